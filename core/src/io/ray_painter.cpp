#include "io/ray_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "io/smooth_normals.h"

namespace preshape {

namespace {

constexpr double kCrease = 35.0 * std::numbers::pi / 180.0;
constexpr float kStep = 5.0F;  ///< of a channel, from which on a border is seen

Eigen::Vector3f background() {
  const Rgb colour = picture_ink(PictureInk::kBackground);
  return Eigen::Vector3f(colour[0], colour[1], colour[2]);
}

/// Two lights that go with the camera and a soft light from all around; what turns away from the eye is
/// darker, so that outlines stand out.
float light_on(const Eigen::Vector3f& n_E) {
  static const Eigen::Vector3f key = Eigen::Vector3f(-0.5F, 0.65F, 0.6F).normalized(),
                               fill = Eigen::Vector3f(0.75F, -0.1F, 0.5F).normalized();
  const float direct = 0.5F * std::max(0.0F, n_E.dot(key)) + 0.15F * std::max(0.0F, n_E.dot(fill));
  return (0.5F + 0.06F * n_E.y() + direct) * (0.7F + 0.3F * std::min(1.0F, 2.5F * n_E.z()));
}

Rgb rounded(const Eigen::Vector3f& colour) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<std::uint8_t>(
        std::lround(std::clamp(colour[static_cast<Eigen::Index>(c)], 0.0F, 255.0F)));
  return rgb;
}

/// A rectangle of pixels.
struct Rectangle {
  Eigen::Vector2d lower = Eigen::Vector2d::Constant(INFINITY), upper = Eigen::Vector2d::Constant(-INFINITY);

  void cover(const Eigen::Vector2d& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  bool holds(const Eigen::Vector2d& p) const {
    return (p.array() >= lower.array() - 1.0).all() && (p.array() <= upper.array() + 1.0).all();
  }
};

Rectangle seen(const PicturePanel& panel, const TriangleMesh& mesh_O) {
  Rectangle rectangle;
  for (const auto& vertex : mesh_O.vertices) rectangle.cover(panel.pixel(vertex));
  return rectangle;
}

}  // namespace

/// A part that is ready for rays.
struct RayPainter::Caster {
  PicturePart part;
  std::unique_ptr<CollisionScene> scene;
  std::vector<std::array<Eigen::Vector3f, 3>> normals;

  const PictureMaterial& material(const RayHit& hit) const {
    return part.materials[part.material_of[static_cast<std::size_t>(hit.triangle)]];
  }

  /// Where the hit is between the corners decides the normal.
  Eigen::Vector3f normal(const Ray& ray, const RayHit& hit) const {
    const auto t = static_cast<std::size_t>(hit.triangle);
    const Eigen::Vector3d p = ray.origin + hit.distance * ray.direction, area = part.mesh_O.area_vector(t);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d b = part.mesh_O.corner(t, (k + 1) % 3) - p,
                            c = part.mesh_O.corner(t, (k + 2) % 3) - p;
      sum += static_cast<float>(b.cross(c).dot(area) / area.squaredNorm()) *
             normals[t][static_cast<std::size_t>(k)];
    }
    return sum.normalized();
  }

  /// Hits of the rays whose pixels can see it.
  std::vector<RayHit> cast(const Rectangle& rectangle, const std::vector<Eigen::Vector2d>& pixels,
                           const std::vector<Ray>& rays) const {
    std::vector<Ray> near;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!rectangle.holds(pixels[i])) continue;
      near.push_back(rays[i]);
      which.push_back(i);
    }
    std::vector<RayHit> met(near.size()), hits(rays.size());
    scene->cast(near, met);
    for (std::size_t k = 0; k < which.size(); ++k) hits[which[k]] = met[k];
    return hits;
  }

  Eigen::Vector3f colour(const Eigen::Matrix3f& R_EO, const Ray& ray, const RayHit& hit) const {
    const PictureMaterial& look = material(hit);
    if (!look.shaded) return look.colour;
    Eigen::Vector3f n_E = R_EO * normal(ray, hit);
    if (n_E.z() < 0.0F) n_E = -n_E;
    return (light_on(n_E) * look.colour).cwiseMin(255.0F);
  }
};

RayPainter::RayPainter(std::vector<PicturePart> parts, const CollisionBackend& collision) {
  for (auto& part : parts) {
    Caster caster{std::move(part), nullptr, {}};
    caster.scene = collision.build(caster.part.mesh_O);
    caster.normals = smooth_normals(caster.part.mesh_O, kCrease);
    casters_.push_back(std::move(caster));
  }
}

RayPainter::~RayPainter() = default;

/// A panel's pixels between the two passes.
struct RayPainter::Canvas {
  const PicturePanel& panel;
  std::vector<Rectangle> rectangles;  ///< where each part is seen
  Colours colours;                    ///< row by row, of the middles of the pixels

  Eigen::Vector3f& at(int x, int y) {
    return colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(panel.width) +
                   static_cast<std::size_t>(x)];
  }
  Eigen::Vector2d place(double x, double y) const { return {panel.left + x, panel.top + y}; }

  bool anything_at(const Eigen::Vector2d& pixel) const {
    return std::any_of(rectangles.begin(), rectangles.end(),
                       [&](const Rectangle& r) { return r.holds(pixel); });
  }
  bool differs_from_neighbours(int x, int y) {
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int u = std::clamp(x + dx, 0, panel.width - 1), v = std::clamp(y + dy, 0, panel.height - 1);
      if ((at(u, v) - at(x, y)).cwiseAbs().maxCoeff() > kStep) return true;
    }
    return false;
  }
};

/// What is seen at some pixels: the first part, then all others from the farthest to the nearest.
RayPainter::Colours RayPainter::colours(const Canvas& canvas,
                                        const std::vector<Eigen::Vector2d>& pixels) const {
  std::vector<Ray> rays;
  for (const auto& pixel : pixels) rays.push_back(canvas.panel.ray(pixel));
  std::vector<std::vector<RayHit>> hits;
  for (std::size_t p = 0; p < casters_.size(); ++p)
    hits.push_back(casters_[p].cast(canvas.rectangles[p], pixels, rays));
  const Eigen::Matrix3f R_EO = canvas.panel.R_OE.transpose().cast<float>();
  Colours colours(rays.size(), background());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayHit& solid = hits.front()[i];
    if (solid.met()) colours[i] = casters_.front().colour(R_EO, rays[i], solid);
    order.clear();
    for (std::size_t p = 1; p < casters_.size(); ++p) {
      if (hits[p][i].met()) order.push_back(p);
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return hits[a][i].distance > hits[b][i].distance; });
    for (const std::size_t p : order) {
      const PictureMaterial& look = casters_[p].material(hits[p][i]);
      const float opacity = hits[p][i].distance < solid.distance ? look.opacity : look.hidden_opacity;
      if (opacity > 0.0F)
        colours[i] += opacity * (casters_[p].colour(R_EO, rays[i], hits[p][i]) - colours[i]);
    }
  }
  return colours;
}

void RayPainter::paint_middles(Canvas& canvas, int y) const {
  std::vector<Eigen::Vector2d> pixels;
  std::vector<int> columns;
  for (int x = 0; x < canvas.panel.width; ++x) {
    const Eigen::Vector2d pixel = canvas.place(x + 0.5, y + 0.5);
    if (!canvas.anything_at(pixel)) continue;
    pixels.push_back(pixel);
    columns.push_back(x);
  }
  const Colours row = colours(canvas, pixels);
  for (std::size_t i = 0; i < row.size(); ++i) canvas.at(columns[i], y) = row[i];
}

void RayPainter::paint_row(Canvas& canvas, int y, Image& image) const {
  std::vector<Eigen::Vector2d> pixels;
  std::vector<int> borders;
  for (int x = 0; x < canvas.panel.width; ++x) {
    image.at(canvas.panel.left + x, canvas.panel.top + y) = rounded(canvas.at(x, y));
    if (!canvas.differs_from_neighbours(x, y)) continue;
    borders.push_back(x);
    for (const auto& [u, v] : {std::pair{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}})
      pixels.push_back(canvas.place(x + u, y + v));
  }
  const Colours fine = colours(canvas, pixels);
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const Eigen::Vector3f mean = 0.25F * (fine[4 * i] + fine[4 * i + 1] + fine[4 * i + 2] + fine[4 * i + 3]);
    image.at(canvas.panel.left + borders[i], canvas.panel.top + y) = rounded(mean);
  }
}

void RayPainter::paint(const PicturePanel& panel, Image& image) const {
  std::vector<Rectangle> rectangles;
  for (const Caster& caster : casters_) rectangles.push_back(seen(panel, caster.part.mesh_O));
  const auto count = static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(panel.height);
  Canvas canvas{panel, std::move(rectangles), Colours(count, background())};
  tbb::parallel_for(0, panel.height, [&](int y) { paint_middles(canvas, y); });
  tbb::parallel_for(0, panel.height, [&](int y) { paint_row(canvas, y, image); });
}

}  // namespace preshape
