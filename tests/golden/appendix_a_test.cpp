#include "preshape/base/random.h"
#include "support/analysis.h"
#include "support/near.h"
#include "support/sample.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("golden");

namespace {

using Six = Eigen::Matrix<double, 6, 1>;

Value coefficients(double ka, double ko, double kn, double mn) {
  return Value::table({{"ka", ka}, {"ko", ko}, {"kn", kn}, {"mn", mn}});
}

/// The wrench of a box by the formulas alone, contact by contact, with no mesh and no rays.
Six box_wrench(const Eigen::Vector3d& size, int plane_number, double x, double U, const Eigen::Vector4d& k) {
  const ApproachPlane plane = thesis_planes()[static_cast<std::size_t>(plane_number - 1)];
  const double half_o = 0.5 * std::abs(plane.n_f.dot(size)), depth = std::abs(plane.transverse.dot(size));
  const int vf = depth < 2 * U - 1e-9 ? 1 : depth < 4 * U - 1e-9 ? 2 : 3;
  Six sum = Six::Zero();
  const auto add = [&](const Eigen::Vector3d& n, double place, double along_o) {
    const Eigen::Vector3d r = x * plane.a + place * plane.transverse + along_o * plane.n_f;
    const Eigen::Vector3d f = k[0] * plane.a + k[2] * n + k[1] * n.cross(plane.a);
    sum.head<3>() += f;
    sum.tail<3>() += k[3] * n + r.cross(f);
  };
  const std::vector<double> places = vf == 1 ? std::vector<double>{0} : vf == 2 ? std::vector<double>{-U / 2, U / 2}
                                                                            : std::vector<double>{-U, 0, U};
  for (const double place : places) add(plane.n_f, place, -half_o);
  add(-plane.n_f, 0, half_o);
  return sum;
}

struct Row {
  int plane;
  double x;
  int vf;
  std::array<double, 6> W;
};

}  // namespace

TEST_CASE("Appendix A: the box's table comes out to the digits given") {
  const Analysis analysis(coefficients(0.15, 0.15, 1.0, 0.3));
  const auto box = analysis.sense(centred_box({0.175, 0.683, 0.339}));
  const std::vector<Row> rows = {{1, -0.045, 2, {0.450, -1.000, 0.150, 0.154, -0.293, -0.006}},
                                 {1, 0.059, 2, {0.450, -1.000, 0.150, 0.154, -0.309, -0.110}},
                                 {3, 0.100, 1, {0, 0.300, 0, 0, 0.051, 0}},
                                 {3, -0.200, 1, {0, 0.300, 0, 0, 0.051, 0}},
                                 {5, -0.045, 2, {0.450, 1.000, -0.150, 0.154, 0.293, 0.006}},
                                 {10, -0.045, 3, {2.000, -0.300, 0.600, 0.587, -0.064, 0.052}},
                                 {12, 0.059, 3, {-2.000, 0.300, 0.600, -0.618, -0.144, 0.052}}};
  for (const Row& row : rows) {
    const auto half = box->half_extent_a_m[static_cast<std::size_t>(row.plane - 1)];
    const VirtualGrasp grasp = analysis.analyser->analyse(*box, {row.plane - 1, row.x / half, 0});
    INFO("plane ", row.plane, " x ", row.x);
    REQUIRE(grasp.is_grasp());
    CHECK(grasp.virtual_fingers == row.vf);
    // Half of the last printed digit, and a rounding of the inputs, which are printed to three digits themselves.
    CHECK_NEAR(grasp.resultant.vector(), Six(Eigen::Map<const Six>(row.W.data())), 1.1e-3);
  }
}

TEST_CASE("The wrench of any box on any plane at any station is what the formulas say") {
  Random random(12);
  const Eigen::Vector4d k(0.45, 0.25, 1.0, 0.8);
  const Analysis analysis;
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d size(random.uniform(0.1, 1.0), random.uniform(0.1, 1.0), random.uniform(0.1, 1.0));
    const auto box = analysis.sense(centred_box(size));
    for (int plane = 1; plane <= 12; ++plane) {
      const double fraction = random.uniform(-0.95, 0.95);
      const double x = fraction * box->half_extent_a_m[static_cast<std::size_t>(plane - 1)];
      const VirtualGrasp grasp = analysis.analyser->analyse(*box, {plane - 1, fraction, 0});
      const double depth = std::abs(thesis_planes()[static_cast<std::size_t>(plane - 1)].transverse.dot(size));
      // Two forefingers half a U from the middle need half a U to either side, which a 2U depth always has.
      INFO("plane ", plane, " depth ", depth);
      REQUIRE(grasp.is_grasp());
      CHECK_NEAR(grasp.resultant.vector(), box_wrench(size, plane, x, 1.0 / 6.0, k), 1e-12);
      CHECK(grasp.stability == 6.0);
    }
  }
}

TEST_CASE("The depth rules see a 2U cube as 2U deep, although its file has a rounding less") {
  const Analysis analysis;
  const double U = 1.0 / 6.0;
  const auto cube = analysis.sense(centred_box(Eigen::Vector3d::Constant(static_cast<float>(2 * U) * (1 - 1e-7))));
  for (int plane = 0; plane < 12; ++plane) CHECK(analysis.analyser->analyse(*cube, {plane, 0.25, 0}).virtual_fingers == 2);
}

TEST_CASE("Turning object and planes turns the wrench with them") {
  Random random(13);
  const Analysis straight;
  const Eigen::Vector3d size(0.3, 0.5, 0.4);
  const auto box = straight.sense(centred_box(size));
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d R = random_rotation(random);
    Analysis oblique;
    oblique.planes.clear();
    for (const auto& plane : straight.planes) {
      oblique.planes.push_back(ApproachPlane::along(R * plane.a, R * plane.n_f));
    }
    oblique.analyser = std::make_shared<PreshapeAnalyser>(
        PreshapeAnalyser::Models{registry().create<ContactModel>("salisbury_soft_finger"),
                                 {registry().create<QualityMeasure>("sta_manu")}},
        oblique.hand, oblique.planes, ApproachSymbols(FuzzyPartition::thesis(), oblique.settings.universe), oblique.settings);
    const auto turned_box = oblique.sense(turned(centred_box(size), R));
    const int plane = static_cast<int>(random.below(12));
    const double half = box->half_extent_a_m[static_cast<std::size_t>(plane)];
    const double x = random.uniform(-0.9, 0.9) * half;
    const auto before = straight.analyser->analyse(*box, {plane, x / half, 0});
    const auto after = oblique.analyser->analyse(
        *turned_box, {plane, x / turned_box->half_extent_a_m[static_cast<std::size_t>(plane)], 0});
    REQUIRE(before.is_grasp());
    REQUIRE(after.is_grasp());
    CHECK_NEAR(after.resultant.vector(), before.resultant.rotated(R).vector(), 1e-9);
  }
}

TEST_SUITE_END();
