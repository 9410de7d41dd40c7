#include <numbers>

#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "support/analysis.h"
#include "support/near.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

using Status = VirtualGrasp::Status;
using Eigen::Vector3d;

constexpr double U = 1.0 / 6.0;
/// Plane 1: the hand comes along +X, the forefingers push -Y, fingers stand side by side along Z.
constexpr int kPlane = 0;

VirtualGrasp grasp_at(const TriangleMesh& mesh, double x, int fingers = 0, AnalysisSettings settings = {}) {
  const Analysis analysis({}, settings);
  return analysis.analyser->analyse(*analysis.sense(mesh), {kPlane, x, fingers});
}

bool says(const VirtualGrasp& grasp, const char* part) { return grasp.detail.find(part) != std::string::npos; }

void check_same(const VirtualGrasp& a, const VirtualGrasp& b) {
  CHECK(a.status == b.status);
  CHECK(a.detail == b.detail);
  CHECK(a.plane == b.plane);
  CHECK(a.approach_m == b.approach_m);
  CHECK(a.virtual_fingers == b.virtual_fingers);
  CHECK(a.depth_m == b.depth_m);
  CHECK(a.opening_m == b.opening_m);
  CHECK(a.fingers == b.fingers);
  REQUIRE(a.contacts.size() == b.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    CHECK(a.contacts[i].p_OC == b.contacts[i].p_OC);
    CHECK(a.contacts[i].n == b.contacts[i].n);
  }
  CHECK(a.resultant.vector() == b.resultant.vector());
  CHECK(a.quality == b.quality);
  CHECK(a.stability == b.stability);
  CHECK(a.manipulability == b.manipulability);
}

}  // namespace

TEST_CASE("Analyser: a finger that passes the object by is named, and there are no contacts") {
  // Two posts: the thumb closes between them. A third post in the middle: the thumb meets it, the index does not.
  const auto post = [](double z) { return box_between({-0.2, -0.2, z - 0.05}, {0.2, 0.2, z + 0.05}); };
  const auto thumb = grasp_at(joined({post(-0.3), post(0.3)}), 0.0);
  CHECK(thumb.status == Status::kMissed);
  CHECK(says(thumb, "the thumb passes"));
  CHECK(thumb.contacts.empty());
  const auto index = grasp_at(joined({post(-0.3), post(0.0), post(0.3)}), 0.0);
  CHECK(index.status == Status::kMissed);
  CHECK(says(index, "the index finger passes"));
  CHECK(index.virtual_fingers == 3);
  CHECK(index.contacts.empty());
}

TEST_CASE("Analyser: a station beside the object's material has no section") {
  const auto apart = joined({box_between({-0.5, -0.1, -0.1}, {-0.3, 0.1, 0.1}), box_between({0.3, -0.1, -0.1}, {0.5, 0.1, 0.1})});
  const auto between = grasp_at(apart, 0.0);
  CHECK(between.status == Status::kNoSection);
  CHECK(says(between, "no section"));
  CHECK(between.contacts.empty());
  CHECK(grasp_at(apart, 0.8).is_grasp());
}

TEST_CASE("Analyser: normals oppose each other within the angle allowed, and not beyond it") {
  const auto sides = [](double degrees) {  // a wedge whose normals are `degrees` from exact opposition
    return wedge(0.4, 0.4 * std::tan(0.5 * degrees * std::numbers::pi / 180), 0.3);
  };
  AnalysisSettings settings;
  CHECK(grasp_at(sides(44.9), 0.0).is_grasp());
  const auto beyond = grasp_at(sides(45.1), 0.0);
  CHECK(beyond.status == Status::kNoOpposition);
  CHECK(says(beyond, "within 45 degrees"));
  settings.opposition_angle_deg = 20;
  CHECK(grasp_at(sides(19.9), 0.0, 0, settings).is_grasp());
  CHECK(grasp_at(sides(20.1), 0.0, 0, settings).status == Status::kNoOpposition);
  settings.opposition_angle_deg = 0;
  CHECK(grasp_at(centred_box({0.3, 0.3, 0.3}), 0.4, 0, settings).is_grasp());
}

TEST_CASE("Analyser: the thumb must meet the object on its own side of the forefingers' contacts") {
  // Normals are exactly opposed, but the thumb (from -Y) meets the middle block above what the forefingers meet.
  const auto crossed = joined({box_between({-0.2, 0.3, -0.04}, {0.2, 0.4, 0.04}), box_between({-0.2, -0.4, -0.25}, {0.2, -0.3, -0.06}),
                               box_between({-0.2, -0.4, 0.06}, {0.2, -0.3, 0.25})});
  const auto grasp = grasp_at(crossed, 0.0);
  CHECK(grasp.virtual_fingers == 2);
  CHECK(grasp.status == Status::kNoOpposition);
  CHECK(says(grasp, "beyond"));
  // With thumb and forefingers changed over (plane 5), the fingers close on the blocks from outside.
  const Analysis analysis;
  CHECK(analysis.analyser->analyse(*analysis.sense(crossed), {4, 0.0, 0}).is_grasp());
  const auto level = joined({box_between({-0.2, -0.4, -0.04}, {0.2, 0.4, 0.04}), box_between({-0.2, -0.4, -0.25}, {0.2, -0.3, -0.06}),
                             box_between({-0.2, -0.4, 0.06}, {0.2, -0.3, 0.25})});
  CHECK(grasp_at(level, 0.0).is_grasp());
}

TEST_CASE("Analyser: the opening is the widest distance of thumb and forefingers along the opposition axis") {
  CHECK_NEAR(grasp_at(centred_box({0.3, 0.47, 0.4}), 0.2).opening_m, 0.47, 1e-9);
  // One forefinger stands on a step: 0.5 under the one, 0.3 under the other.
  const auto stepped = joined({box_between({-0.2, -0.25, -0.2}, {0.2, 0.05, 0.2}), box_between({-0.2, 0.05, -0.2}, {0.2, 0.25, -0.02})});
  const auto grasp = grasp_at(stepped, 0.1);
  REQUIRE(grasp.is_grasp());
  CHECK_NEAR(grasp.opening_m, 0.5, 1e-9);
}

TEST_CASE("Analyser: normals point inwards whatever way the triangles are wound") {
  const auto mesh = joined({box_between({-0.2, -0.25, -0.2}, {0.2, 0.05, 0.2}), box_between({-0.1, 0.0, -0.1}, {0.2, 0.25, 0.1})});
  const Analysis analysis;
  const auto right = analysis.sense(mesh), wrong = analysis.sense(inside_out(mesh));
  for (int plane = 0; plane < 12; ++plane) {
    const auto& axes = analysis.planes[static_cast<std::size_t>(plane)];
    const auto a = analysis.analyser->analyse(*right, {plane, 0.15, 0}), b = analysis.analyser->analyse(*wrong, {plane, 0.15, 0});
    CHECK(a.status == b.status);
    REQUIRE(a.contacts.size() == b.contacts.size());
    // Rays come to the same triangles along other sums.
    CHECK_NEAR(a.resultant.vector(), b.resultant.vector(), 64 * kEps);
    for (std::size_t i = 0; i < b.contacts.size(); ++i) {
      CHECK_NEAR(a.contacts[i].n, (i == 0 ? -1.0 : 1.0) * axes.n_f, 4 * kEps);
      CHECK_NEAR(b.contacts[i].n, a.contacts[i].n, 4 * kEps);
    }
  }
}

TEST_CASE("Analyser: fingers stand about the middle of the section, not of the object") {
  const auto askew = joined({box_between({-0.4, -0.1, 0.0}, {0.0, 0.1, 0.4}), box_between({0.0, -0.1, -0.4}, {0.4, 0.1, 0.0})});
  for (const double side : {-1.0, 1.0}) {
    const auto grasp = grasp_at(askew, 0.5 * side);
    REQUIRE(grasp.is_grasp());
    CHECK(grasp.virtual_fingers == 2);
    CHECK_NEAR(grasp.depth_m, 0.4, 1e-9);
    CHECK_NEAR(grasp.contacts[0].p_OC, Vector3d(0.2 * side, -0.1, -0.2 * side), 1e-9);
    CHECK_NEAR(grasp.contacts[1].p_OC, Vector3d(0.2 * side, 0.1, -0.2 * side - U / 2), 1e-9);
    CHECK_NEAR(grasp.contacts[2].p_OC, Vector3d(0.2 * side, 0.1, -0.2 * side + U / 2), 1e-9);
    CHECK(grasp.fingers == std::vector<std::string>{"thumb", "index", "middle"});
  }
}

TEST_CASE("Analyser: a transverse offset moves all fingers together by its share of the section's half width") {
  const auto mesh = box_between({-0.3, -0.1, -0.2}, {0.3, 0.1, 0.6});  // section 0.8 wide; its middle is the box's, O
  const Analysis analysis({}, {});
  const auto object = analysis.sense(mesh);
  const auto middle = analysis.analyser->analyse(*object, {kPlane, 0.1, 2, 0.0});
  for (const double offset : {-0.5, 0.25}) {
    const auto moved = analysis.analyser->analyse(*object, {kPlane, 0.1, 2, offset});
    REQUIRE(moved.is_grasp());
    CHECK(moved.transverse_fraction == offset);
    for (std::size_t i = 0; i < moved.contacts.size(); ++i) {
      CHECK_NEAR(moved.contacts[i].p_OC, (middle.contacts[i].p_OC + Vector3d(0, 0, 0.4 * offset)).eval(), 1e-7);
    }
  }
  CHECK(analysis.analyser->analyse(*object, {kPlane, 0.1, 2, 1.0}).status == Status::kMissed);
}

TEST_CASE("Analyser: the rules give the finger count of the section's depth, a free search what it asks for") {
  for (const auto& [depth_U, fingers] : std::vector<std::pair<double, int>>{{1.9, 1}, {2.1, 2}, {3.9, 2}, {4.1, 3}}) {
    CHECK(grasp_at(centred_box({0.3, 0.3, depth_U * U}), 0.0).virtual_fingers == fingers);
  }
  const auto box = centred_box({0.3, 0.3, 3 * U});
  for (int fingers = 1; fingers <= 3; ++fingers) {
    const auto grasp = grasp_at(box, 0.0, fingers);
    REQUIRE(grasp.is_grasp());
    CHECK(grasp.virtual_fingers == fingers);
    CHECK(grasp.contacts.size() == static_cast<std::size_t>(fingers) + 1);
  }
  CHECK(grasp_at(centred_box({0.3, 0.3, 1.5 * U}), 0.0, 3).status == Status::kMissed);

  AnalysisSettings settings;
  const Preshape three{1, 4, 3};
  CHECK(Analysis().analyser->station(*Analysis().sense(box), three).virtual_fingers == 0);
  settings.free_virtual_fingers = true;
  CHECK(Analysis({}, settings).analyser->station(*Analysis({}, settings).sense(box), three).virtual_fingers == 3);
}

TEST_CASE("Analyser: a batch of stations gives what each gives alone") {
  const Analysis analysis;
  const auto object = analysis.sense(joined({wedge(0.5, 0.15, 0.6), box_between({-0.3, -0.3, -0.1}, {-0.2, 0.3, 0.5})}));
  Random random(31);
  std::vector<Station> stations;
  for (int i = 0; i < 200; ++i) {
    stations.push_back({static_cast<int>(random.below(12)), random.uniform(-1.1, 1.1), static_cast<int>(random.below(4))});
  }
  std::vector<VirtualGrasp> grasps(stations.size());
  analysis.analyser->analyse(*object, stations, grasps);
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < stations.size(); ++i) {
    check_same(grasps[i], analysis.analyser->analyse(*object, stations[i]));
    ++seen[static_cast<std::size_t>(grasps[i].status)];
  }
  // The example is worth something: grasps, stations beside the object and missed fingers are all among them.
  CHECK(seen[static_cast<std::size_t>(Status::kGrasp)] > 20);
  CHECK(seen[static_cast<std::size_t>(Status::kNoSection)] > 0);
  CHECK(seen[static_cast<std::size_t>(Status::kMissed)] > 0);
}

TEST_CASE("Analyser: a search spares itself the measures and gets the same wrench") {
  const Analysis analysis;
  const auto object = analysis.sense(centred_box({0.3, 0.4, 0.5}));
  const Station station{7, 0.3, 0};
  VirtualGrasp bare;
  analysis.analyser->analyse(*object, {&station, 1}, {&bare, 1}, false);
  const auto full = analysis.analyser->analyse(*object, station);
  CHECK(bare.resultant.vector() == full.resultant.vector());
  CHECK(bare.quality.empty());
  CHECK(full.quality.size() == analysis.analyser->quality_numbers().size());
  CHECK(full.stability == 6.0);
}

TEST_CASE("Analyser: the outermost stations that symbols name are on a box, from every plane") {
  const Analysis analysis;
  const auto object = analysis.sense(centred_box({0.3, 0.7, 0.4}));
  for (int plane = 0; plane < 12; ++plane) {
    for (const double x : {-0.95, 0.95}) CHECK(analysis.analyser->analyse(*object, {plane, x, 0}).is_grasp());
  }
}

TEST_CASE("Analyser: an object wider than the hand opens is still met from outside") {
  const auto grasp = grasp_at(centred_box({0.3, 3.0, 0.3}), 0.0);
  REQUIRE(grasp.is_grasp());
  CHECK_NEAR(grasp.contacts[0].p_OC.y(), -1.5, 1e-9);
  CHECK_NEAR(grasp.contacts[1].p_OC.y(), 1.5, 1e-9);
  CHECK_NEAR(grasp.opening_m, 3.0, 1e-9);
}

TEST_CASE("Analyser: the station that a preshape names has that preshape, in either universe") {
  for (const auto universe : {ApproachSymbols::Universe::kHalfExtent, ApproachSymbols::Universe::kNormalised}) {
    AnalysisSettings settings;
    settings.universe = universe;
    const Analysis analysis({}, settings);
    // Half extents of at least L, so that in the universe of normalised lengths every symbol is on the object too.
    const auto object = analysis.sense(centred_box({2.4, 2.2, 2.6}));
    for (int plane = 1; plane <= 12; ++plane) {
      for (int symbol = 1; symbol <= 7; ++symbol) {
        const Station station = analysis.analyser->station(*object, {plane, symbol, 3});
        CHECK(station.plane == plane - 1);
        const auto grasp = analysis.analyser->analyse(*object, station);
        REQUIRE(grasp.is_grasp());
        CHECK(analysis.analyser->preshape(*object, grasp) == Preshape{plane, symbol, 3});
      }
    }
  }
}

TEST_CASE("Analyser: without stability and manipulability among the measures it says what to add") {
  const auto analyser = [] {
    return PreshapeAnalyser({registry().create<ContactModel>("salisbury_soft_finger"), {}}, unit_hand(), thesis_planes(),
                            ApproachSymbols(FuzzyPartition::thesis(), ApproachSymbols::Universe::kHalfExtent), {});
  };
  CHECK_THROWS_SAYING(analyser(), InputError, "no quality measure gives 'stability', which the classifier reads; add 'sta_manu'");
}

TEST_SUITE_END();
