#include "preshape/io/picture.h"

#include <numbers>

#include "preshape/base/error.h"
#include "preshape/geometry/solid_mesh.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

const CollisionBackend& brute() {
  static const auto backend = registry().create<CollisionBackend>("brute");
  return *backend;
}

/// Trees where they are built: brute force is slow on many triangles.
const CollisionBackend& rays() {
  static const auto backend =
      registry().create<CollisionBackend>(registry().has("collision", "fcl") ? "fcl" : "brute");
  return *backend;
}

GraspScene scene_of(TriangleMesh mesh_O) {
  GraspScene scene;
  scene.title = "a test";
  scene.verdict = "Nobody grasps it.";
  scene.object_O = std::move(mesh_O);
  return scene;
}

/// A box held between two fingers, with wrenches, and a hand of two links in two postures.
GraspScene held_box() {
  GraspScene scene = scene_of(centred_box({0.06, 0.04, 0.03}));
  for (const double side : {1.0, -1.0}) {
    scene.contacts.push_back(ContactFrame::at({0.01 * side, 0.02 * side, 0.005}, {0, -side, 0}, {1, 0, 0}));
    scene.F_C_O.push_back(Wrench({0.1, -side, 0.2}, {0, 0.3 * side, 0}));
    scene.fingers.push_back(side > 0 ? "thumb" : "index");
  }
  scene.resultant_O = Wrench({0.2, 0, 0.4}, {0.1, 0, 0});
  const Pose far{Eigen::Matrix3d::Identity(), {-0.07, 0, 0}},
      near{Eigen::Matrix3d::Identity(), {-0.05, 0.01, 0}};
  scene.links = {{"palm", {Solid::Kind::kBox, 0, 0, {0.01, 0.03, 0.03}}, {far, far}},
                 {"thumb link 1", {Solid::Kind::kCapsule, 0.008, 0.02, {}}, {far, near}}};
  scene.frames = 2;
  return scene;
}

/// One view, nothing but the object.
PictureOptions bare(const Eigen::Vector3d& direction, int width = 500, int height = 400) {
  PictureOptions options;
  options.width = width, options.height = height;
  options.views = {picture_view(direction)};
  options.marks = options.words = false;
  return options;
}

bool is_background(const Rgb& pixel) {
  return pixel == picture_ink(PictureInk::kBackground);
}

std::size_t drawn_pixels(const Image& image) {
  return static_cast<std::size_t>(std::count_if(image.pixels().begin(), image.pixels().end(),
                                                [](const Rgb& p) { return !is_background(p); }));
}

/// The pixels that anything is drawn in.
Eigen::AlignedBox2d drawn_box(const Image& image) {
  Eigen::AlignedBox2d box;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (is_background(image.at(x, y))) continue;
      box.extend(Eigen::Vector2d(x, y));
      box.extend(Eigen::Vector2d(x + 1, y + 1));
    }
  }
  return box;
}

/// An outline of `length` px crosses about 4 / pi as many pixels, each drawn when a quarter of it is covered
/// or more.
void check_area(const Image& image, double area, double length) {
  const auto drawn = static_cast<double>(drawn_pixels(image));
  INFO("drawn ", drawn, " of ", area, " px, outline ", length, " px");
  CHECK(drawn >= area - 0.3 * length);
  CHECK(drawn <= area + 1.0 * length);
}

bool is_red(const Rgb& p) {
  return p[0] > 90 && p[0] > 2 * p[1] && p[0] > 2 * p[2];
}

}  // namespace

TEST_CASE("Picture: a box covers the area of its projection, from any side") {
  const Eigen::Vector3d extents(0.06, 0.04, 0.03);
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(1, 0, 0),
                                           Eigen::Vector3d(-1, -2, -1.5), Eigen::Vector3d(0.2, 1, 0.4)}) {
    const GraspScene scene = scene_of(centred_box(extents));
    const PictureOptions options = bare(direction);
    const double pixel_m = picture_panels(scene, options).front().pixel_m;
    const Eigen::Vector3d d = direction.normalized().cwiseAbs();
    const double area = d.x() * extents.y() * extents.z() + d.y() * extents.z() * extents.x() +
                        d.z() * extents.x() * extents.y();
    double outline = 0.0;  // of the projected box: each edge direction twice
    for (int k = 0; k < 3; ++k) outline += 2.0 * extents[k] * std::sqrt(1.0 - d[k] * d[k]);
    check_area(picture(scene, rays(), options), area / (pixel_m * pixel_m), outline / pixel_m);
  }
}

TEST_CASE("Picture: a sphere covers a disc, in perspective the larger one that its tangents cut") {
  const double r = 0.04, pi = std::numbers::pi;
  const GraspScene scene = scene_of(solid_mesh({Solid::Kind::kSphere, r, 0.0, {}}, 96));
  PictureOptions options = bare({1, -1, 0.3}, 300, 240);
  const auto flat = picture_panels(scene, options).front();
  const double radius = r / flat.pixel_m;
  check_area(picture(scene, rays(), options), pi * radius * radius, 2 * pi * radius);
  options.field_of_view = 0.8;
  const auto deep = picture_panels(scene, options).front();
  const double distance = deep.p_OE.norm(), seen = std::tan(std::asin(r / distance)) / deep.pixel_m;
  CHECK(distance < 4 * r);  // near enough for the difference to show
  check_area(picture(scene, rays(), options), pi * seen * seen, 2 * pi * seen);
}

TEST_CASE("Picture: where a panel says that a point is seen, there it is drawn, and it fills the picture") {
  const GraspScene scene = scene_of(box_between({0.01, -0.02, 0.0}, {0.09, 0.01, 0.03}));
  for (const double field_of_view : {0.0, 0.6}) {
    PictureOptions options = bare({-1, -2, -1});
    options.field_of_view = field_of_view;
    const auto panel = picture_panels(scene, options).front();
    Eigen::AlignedBox2d corners;
    for (const auto& corner : scene.object_O.vertices) {
      const Eigen::Vector2d pixel = panel.pixel(corner);
      corners.extend(pixel);
      const Ray ray = panel.ray(pixel);
      CHECK_NEAR((corner - ray.origin).cross(ray.direction).norm(), 0.0, 1e-12);
    }
    const Eigen::AlignedBox2d drawn = drawn_box(picture(scene, rays(), options));
    CHECK_NEAR(drawn.min(), corners.min(), 2.0);
    CHECK_NEAR(drawn.max(), corners.max(), 2.0);
    CHECK((drawn.sizes().x() > 450 || drawn.sizes().y() > 350));
    CHECK(Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(500, 400)).contains(drawn));
  }
}

TEST_CASE("Picture: up is up, and what is to the right of the camera is on the right") {
  const auto panel = picture_panels(scene_of(centred_box({0.1, 0.1, 0.1})), bare({0, 1, 0})).front();
  const Eigen::Vector2d middle = panel.pixel({0, 0, 0});
  CHECK(panel.pixel({0, 0, 0.05}).y() < middle.y());
  CHECK(panel.pixel({0.05, 0, 0}).x() > middle.x());
  CHECK_NEAR(panel.pixel({0, 0.05, 0}), middle, 1e-9);
}

TEST_CASE("Picture: contacts are marked where they are, in each of three views, and nothing else is red") {
  GraspScene scene = scene_of(centred_box({0.06, 0.04, 0.03}));
  scene.contacts = {ContactFrame::at({0.01, 0.02, 0.01}, {0, -1, 0}, {1, 0, 0}),
                    ContactFrame::at({-0.02, -0.02, -0.005}, {0, 1, 0}, {1, 0, 0})};
  PictureOptions options;
  options.width = 1200, options.height = 420, options.words = false;
  const Image image = picture(scene, rays(), options);
  const auto panels = picture_panels(scene, options);
  REQUIRE(panels.size() == 3);
  const double size = Eigen::Vector3d(0.03, 0.02, 0.015).norm(),
               radius = 0.04 * size / panels.front().pixel_m;
  const auto all_red =
      static_cast<std::size_t>(std::count_if(image.pixels().begin(), image.pixels().end(), is_red));
  std::size_t red = 0;
  for (const auto& panel : panels) {
    for (const auto& contact : scene.contacts) {
      if (contact.n.dot(panel.view.direction) < -1e-9) continue;  // behind the object
      const Eigen::Vector2d at = panel.pixel(contact.p_OC);
      std::size_t near = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
          near += is_red(image.at(x, y)) && (Eigen::Vector2d(x + 0.5, y + 0.5) - at).norm() < radius + 1.5;
      }
      INFO(panel.view.name, ": ", near, " red pixels at ", at.x(), " ", at.y(), ", radius ", radius);
      CHECK(near > 0.3 * std::numbers::pi * radius * radius);
      red += near;
    }
  }
  CHECK(red > 0);
  CHECK(red == all_red);
}

TEST_CASE(
    "Picture: the hand is drawn in the posture asked for, translucent, and not at all when it is not to be "
    "seen") {
  const GraspScene scene = held_box();
  PictureOptions options = bare({0, 0, -1});
  const Image last = picture(scene, rays(), options);
  options.frame = 1;
  CHECK(picture(scene, rays(), options).pixels() == last.pixels());
  options.frame = 0;
  CHECK(picture(scene, rays(), options).pixels() != last.pixels());
  options.frame = -1;
  options.hand_opacity = 0.0;
  const Image none = picture(scene, rays(), options);
  CHECK(none.pixels() == picture(scene_of(scene.object_O), rays(), options).pixels());
  options.frame = 2, options.hand_opacity = 1.0;
  CHECK_THROWS_SAYING(picture(scene, rays(), options), InputError,
                      "a picture of posture 2 cannot be made: the motion has 2 postures");
}

TEST_CASE(
    "Picture: the approach volume tints what is behind it, is outlined at its entrance and named, but only "
    "with marks") {
  GraspScene scene = held_box();
  ApproachVolume volume;
  volume.mesh_O = box_between({-0.06, -0.05, -0.01}, {-0.035, 0.05, 0.01});
  volume.entrance_O = {
      {-0.035, -0.05, -0.01}, {-0.035, 0.05, -0.01}, {-0.035, 0.05, 0.01}, {-0.035, -0.05, 0.01}};
  volume.centroid_O = {-0.035, 0, 0};
  scene.approach_volume = volume;
  PictureOptions options = bare({0, 0, -1});
  options.hand_opacity = 0.0, options.marks = true;
  const Image image = picture(scene, rays(), options);
  const auto panel = picture_panels(scene, options).front();
  const auto at = [&](const Image& seen, const Eigen::Vector3d& p_O) {
    const Eigen::Vector2d pixel = panel.pixel(p_O);
    return seen.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  };
  const auto yellow = [](const Rgb& p) { return p[0] - p[2]; };
  const Eigen::Vector3d inside(-0.055, 0.045, 0), entrance(-0.035, 0.035, 0.01), beyond(-0.025, 0.045, 0);
  CHECK(yellow(at(image, inside)) > 40);
  CHECK(yellow(at(image, entrance)) > 2 * yellow(at(image, inside)));
  CHECK(yellow(at(image, beyond)) < 20);  // the approach plane alone
  const auto has = [&](const Image& seen, PictureInk ink) {
    return std::find(seen.pixels().begin(), seen.pixels().end(), picture_ink(ink)) != seen.pixels().end();
  };
  options.words = true;
  CHECK(has(picture(scene, rays(), options), PictureInk::kVolume));  // its patch in the legend
  options.marks = false;
  CHECK_FALSE(has(picture(scene, rays(), options), PictureInk::kVolume));
  options.words = false;
  const Image plain = picture(scene, rays(), options);
  scene.approach_volume.reset();
  CHECK(plain.pixels() == picture(scene, rays(), options).pixels());
}

TEST_CASE(
    "Picture: a link that collides is drawn in the colour of the legend that names it, also inside the "
    "object") {
  GraspScene scene = held_box();
  Pose& X_OS = scene.links[1].X_OS[1];  // lying in the box, all of it
  X_OS.p.setZero();
  X_OS.R << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  PictureOptions options = bare({0, 0, -1});
  const auto pink = [](const Rgb& p) { return p[0] > p[1] + 40 && p[2] > p[1] + 15; };
  const auto count = [&](const Image& image) {
    return std::count_if(image.pixels().begin(), image.pixels().end(), pink);
  };
  CHECK(count(picture(scene, rays(), options)) == 0);
  scene.links[1].collides = true;
  const auto panel = picture_panels(scene, options).front();
  const double area = (std::numbers::pi * 0.008 * 0.008 + 0.04 * 0.016) / (panel.pixel_m * panel.pixel_m);
  const Image inside = picture(scene, rays(), options);
  CHECK(static_cast<double>(count(inside)) > 0.9 * area);
  CHECK(static_cast<double>(count(inside)) < 1.1 * area);
  options.frame = 0;
  CHECK(count(picture(scene, rays(), options)) > 0);  // in every posture
  options.words = true;
  const Image named = picture(scene, rays(), options);
  CHECK(std::find(named.pixels().begin(), named.pixels().end(), picture_ink(PictureInk::kCollision)) !=
        named.pixels().end());
  scene.links[1].name = "index link 1";
  CHECK(picture(scene, rays(), options).pixels() != named.pixels());
}

TEST_CASE("Picture: a second rendering has the same bytes, and FCL's rays draw the same as brute force's") {
  const GraspScene scene = held_box();
  PictureOptions options;
  options.width = 320, options.height = 200;
  const Image image = picture(scene, rays(), options);
  CHECK(png_file(image) == png_file(picture(scene, rays(), options)));
  CHECK(png_file(with_few_colours(image)).size() < png_file(image).size());
  if (!registry().has("collision", "fcl")) {
    MESSAGE("skipped: collision/fcl is not built");
    return;
  }
  CHECK(picture(scene, brute(), options).pixels() == image.pixels());
}

TEST_CASE(
    "Picture: words are written above and below the views, whatever characters they have, and cut where they "
    "are long") {
  GraspScene scene = held_box();
  PictureOptions options;
  options.width = 400, options.height = 300;
  const Image shortly = picture(scene, rays(), options);
  for (int i = 0; i < 400; ++i) scene.verdict += "long \xc3\xa9\x01";
  const auto panel = picture_panels(scene, options).front();
  CHECK(panel.top > 30);
  CHECK(panel.top + panel.height < 270);
  CHECK(picture(scene, rays(), options).pixels() != shortly.pixels());
}

TEST_CASE("Picture: a size, view, field of view or object that cannot be drawn is refused in a sentence") {
  const GraspScene scene = held_box();
  PictureOptions options;
  options.width = 100;
  CHECK_THROWS_SAYING(picture_panels(scene, options), InputError,
                      "a picture of 100 x 620 pixels cannot be drawn; give 240 x 180 to 8192 x 8192");
  options = {};
  options.views = {{"bad", {0, 0, 1}, {0, 0, -2}}};
  CHECK_THROWS_SAYING(picture_panels(scene, options), InputError,
                      "give two directions that are not parallel");
  CHECK_THROWS_SAYING(picture_view({0, 0, 0}), InputError, "give a direction that is not zero");
  options = {};
  options.field_of_view = 2.0;
  CHECK_THROWS_SAYING(picture_panels(scene, options), InputError, "field of view of 2 rad");
  options = {};
  options.width = 240, options.height = 180;
  options.views.assign(20, picture_view({1, 0, 0}));
  CHECK_THROWS_SAYING(picture_panels(scene, options), InputError, "no room for 20 views");
  CHECK_THROWS_SAYING(picture_panels(scene_of({}), {}), InputError, "no triangles");
}

TEST_SUITE_END();
