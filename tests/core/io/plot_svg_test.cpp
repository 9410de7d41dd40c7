#include <cmath>

#include "preshape/base/error.h"
#include "preshape/io/fuzzy_matrix_svg.h"
#include "preshape/io/heat_map_svg.h"
#include "preshape/io/svg.h"
#include "support/near.h"
#include "xml.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

/// Two planes, three stations, one of them without a grasp.
HeatMap small_map() {
  HeatMap map{"mug <&> task", "tfvadi", {0.0, 6.0}, {"1: a", "2: b"}, {-0.5, 0.0, 0.5}, {}};
  for (const double score : {1.25, 4.5, 2.0, 3.0, 0.0, 4.25}) map.cells.push_back({score, ""});
  map.cells[4] = {std::nullopt, "the thumb misses"};
  return map;
}

/// Luminance of "#rrggbb", as grey paper shows it.
double grey(const std::string& colour) {
  const auto channel = [&](std::size_t at) {
    return std::pow(std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0, 2.2);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

/// The fill of the cell whose name ends so.
std::string fill_of(const std::string& svg, const std::string& name) {
  const auto title = svg.find(name + "</title></rect>");
  REQUIRE(title != std::string::npos);
  return svg.substr(svg.rfind("fill=\"", title) + 6, 7);
}

}  // namespace

TEST_CASE("Heat map: a cell a station with its number, well-formed, the reason where there is no grasp") {
  const std::string svg = heat_map_svg(small_map());
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, "</title></rect>") == 6);
  CHECK(count_of(svg, "plane 1: a, x = 0: tfvadi 4.5</title>") == 1);
  CHECK(count_of(svg, "plane 2: b, x = -0.5: tfvadi 3</title>") == 1);
  CHECK(count_of(svg, "plane 2: b, x = 0: no grasp, the thumb misses</title>") == 1);
  CHECK(count_of(svg, ">4.25</text>") == 1);
}

TEST_CASE("Heat map: nearer is lighter and the nearest is framed, also where lower is nearer") {
  HeatMap map = small_map();
  std::string svg = heat_map_svg(map);
  CHECK(grey(fill_of(svg, "tfvadi 4.5")) > grey(fill_of(svg, "tfvadi 4.25")));
  CHECK(grey(fill_of(svg, "tfvadi 4.25")) > grey(fill_of(svg, "tfvadi 1.25")));
  CHECK(count_of(svg, "nearest</title>") == 1);
  const auto frame_of = [](const std::string& text) {
    return text.substr(0, text.find("<title>nearest")).rfind("<path d=\"M");
  };
  const std::string high = svg.substr(frame_of(svg), 30);
  map.scale = {6.0, 0.0};
  svg = heat_map_svg(map);
  CHECK(grey(fill_of(svg, "tfvadi 1.25")) > grey(fill_of(svg, "tfvadi 4.5")));
  CHECK(svg.substr(frame_of(svg), 30) != high);
}

TEST_CASE(
    "Heat map: without a grasp, with one station or with hundreds it is drawn; a missing cell is refused") {
  HeatMap map = small_map();
  for (auto& cell : map.cells) cell = {std::nullopt, ""};
  CHECK(xml_fault(heat_map_svg(map)) == "");
  CHECK(count_of(heat_map_svg(map), "nearest") == 0);
  map.planes.assign(480, "1: a"), map.stations.assign(200, 0.1);
  map.cells.assign(480 * 200, {2.0, ""});
  CHECK(count_of(heat_map_svg(map), "</title></rect>") == 480 * 200);
  map = {"one", "m", {0, 1}, {"1"}, {0.0}, {{0.5, ""}}};
  CHECK(xml_fault(heat_map_svg(map)) == "");
  map.cells.clear();
  CHECK_THROWS_SAYING(heat_map_svg(map), InputError, "1 planes and 1 stations has 0 cells");
}

TEST_CASE(
    "Scale of colours: lightness ascends all the way in even steps, so that grey paper keeps the order") {
  double last = -1.0;
  for (int i = 0; i <= 50; ++i) {
    const double lightness = std::cbrt(grey(svg_scale_colour(i / 50.0)));  // as CIE L*, but for a factor
    CHECK(lightness > last);
    if (last >= 0.0) CHECK(lightness - last < 0.04);
    last = lightness;
  }
  CHECK(svg_scale_colour(-3.0) == svg_scale_colour(0.0));
  CHECK(svg_scale_colour(7.0) == svg_scale_colour(1.0));
}

TEST_CASE(
    "Fuzzy matrices: every degree of task and wrench, the crisp numbers and the scores stand in the "
    "drawing") {
  FuzzyMatrices matrices{
      "Task", "tfvadi", FuzzyPartition::thesis(), {1, 0.1, 1, 0.8, 0.05, -0.3}, std::nullopt};
  matrices.compared = {{1.35, 1, -0.25, 0.0813, 0.7812, 0.2588}, {1, 0.5, 0, 0.6874, 0.125, 0.25}, 2.5624};
  const std::string svg = fuzzy_matrix_svg(matrices);
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, "</title></rect>") == 2 * 6 * 7);
  std::array<double, 7> degrees{};
  for (const auto& [names, vector] :
       {std::pair{"Tx Ty Tz Rx Ry Rz", matrices.task}, {"fx fy fz mx my mz", matrices.compared->wrench}}) {
    for (std::size_t c = 0; c < 6; ++c) {
      matrices.partition.fuzzify(vector[c], degrees);
      CHECK(count_of(svg, fmt::format(">{:.4f}</text>", vector[c])) >= 1);
      for (std::size_t s = 0; s < 7; ++s) {
        CHECK(count_of(svg, fmt::format("<title>{} {}: {:.6g}</title>", std::string(names).substr(3 * c, 2),
                                        matrices.partition[static_cast<int>(s)].name, degrees[s])) == 1);
      }
    }
  }
  for (const double score : matrices.compared->components)
    CHECK(count_of(svg, fmt::format(">{:.4f}</text>", score)) >= 1);
  CHECK(count_of(svg, "2.5624 in all") == 1);
}

TEST_CASE("Fuzzy matrices: without a grasp the second one says so and the task is still there") {
  const FuzzyMatrices matrices{"Task", "tfvadi", FuzzyPartition::thesis(), {1, 0, 0, 0, 0, 0}, std::nullopt};
  const std::string svg = fuzzy_matrix_svg(matrices);
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, "no grasp</text>") == 1);
  CHECK(count_of(svg, "<title>Tx ") == 7);
}

TEST_SUITE_END();
