#include "preshape/io/svg.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "preshape/io/membership_svg.h"
#include "support/near.h"
#include "xml.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

/// The points of the i-th path.
std::vector<Eigen::Vector2d> path_of(const std::string& svg, std::size_t i) {
  static const std::regex path(R"rx(<path d="([^"]*)")rx"), point(R"rx([ML]([-0-9.]+) ([-0-9.]+))rx");
  std::sregex_iterator it(svg.begin(), svg.end(), path);
  std::advance(it, static_cast<std::ptrdiff_t>(i));
  const std::string course = (*it)[1];
  std::vector<Eigen::Vector2d> points;
  for (std::sregex_iterator p(course.begin(), course.end(), point), end; p != end; ++p)
    points.emplace_back(std::stod((*p)[1]), std::stod((*p)[2]));
  return points;
}

std::string drawing(const FuzzyPartition& partition, double bound = 0.5) {
  return membership_svg(partition, findings_of(partition, span_of(partition), bound), "Sets");
}

}  // namespace

TEST_CASE("SVG: any text comes out as well-formed XML") {
  CHECK(xml_fault("<svg><a></svg>\n") != "");
  CHECK(xml_fault("<svg>&</svg>\n") != "");
  Svg svg(100, 50, "a < b & \"c\" > d");
  svg.text(1, 2, "<script>\x01&amp;", SvgAnchor::kMiddle, 12, "red\" onload=\"x");
  svg.path({{0, 0}, {1, 1}}, {.stroke = "blue"}, "]]> & <");
  svg.line(0, 0, 1, 1, {.stroke = "blue", .dash = "4 2", .opacity = 0.5});
  CHECK(xml_fault(svg.file()) == "");
  CHECK(svg.file().find("&lt;script&gt;&amp;amp;") != std::string::npos);
  CHECK(svg.file().find("onload=\"x\"") == std::string::npos);
}

TEST_CASE("SVG: ticks are round numbers, in order, from end to end, no more than asked for") {
  CHECK(SvgScale{0, 1, 0, 100}.ticks(6) == std::vector<double>{0, 0.2, 0.4, 0.2 * 3, 0.8, 1});
  for (const double from : {-1.2, 0.0, 3e-7, -1e9}) {
    for (const double width : {2.4, 1e-6, 7.0, 12345.0}) {
      for (const int count : {2, 6, 13}) {
        const auto ticks = SvgScale{from, from + width, 0, 100}.ticks(count);
        INFO("from ", from, " width ", width, " count ", count);
        CHECK(static_cast<int>(ticks.size()) <= count);
        CHECK(std::is_sorted(ticks.begin(), ticks.end()));
        for (const double x : ticks) CHECK((x >= from - 1e-6 * width && x <= from + (1 + 1e-6) * width));
      }
    }
  }
}

TEST_CASE("Drawing of sets: one line and one label a set, well-formed, no gap where there is none") {
  const auto partition = FuzzyPartition::thesis();
  const std::string svg = drawing(partition);
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, "<path ") == 7);
  for (const Membership& set : partition.sets()) CHECK(count_of(svg, ">" + set.name + "</text>") == 1);
  CHECK(count_of(svg, "<rect ") == 1);  // the background
  CHECK(count_of(drawing(partition, 0.55), "<rect ") == 1 + 4);
  CHECK(svg.find("http", svg.find('>')) == std::string::npos);
}

TEST_CASE("Drawing of sets: a trapezoid's line goes through its corners, and to no others") {
  const auto partition = FuzzyPartition::thesis();
  const auto points = path_of(drawing(partition), 3);  // Zero: -0.15 -0.05 0.05 0.15 of -1.2 .. 1.2
  REQUIRE(points.size() == 4);
  const double left = points[0].x(), right = points[3].x(), width = right - left;
  CHECK_NEAR((points[1].x() - left) / width, 1.0 / 3, 2e-3);
  CHECK_NEAR((points[2].x() - left) / width, 2.0 / 3, 2e-3);
  CHECK(points[1].y() == points[2].y());
  CHECK(points[1].y() < points[0].y());
  CHECK_NEAR(points[0].y(), points[3].y(), 0.011);
}

TEST_CASE("Drawing of sets: a side without width is drawn upright, a set of one point as a needle, curves smoothly") {
  const FuzzyPartition partition({{"crisp", Membership::Shape::kTrapezoid, {0, 0, 1, 1}, false, false},
                                  {"needle", Membership::Shape::kTriangle, {0.5, 0.5, 0.5}, false, false},
                                  {"curve", Membership::Shape::kGaussian, {0.5, 0.3}, false, false}});
  const std::string svg = drawing(partition);
  for (const std::size_t i : {0, 1}) {
    const auto points = path_of(svg, i);
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y() < b.y(); });
    CHECK(high->y() - low->y() > 200);
    CHECK(std::abs(points[0].x() - points[1].x()) < 0.011);
  }
  const auto curve = path_of(svg, 2);
  CHECK(curve.size() > 100);
  for (std::size_t i = 1; i < curve.size(); ++i) CHECK((curve[i] - curve[i - 1]).norm() < 12);
}

TEST_CASE("Drawing of sets: labels of sets that stand close do not run into each other") {
  std::vector<Membership> sets;
  for (int i = 0; i < 30; ++i) sets.push_back({fmt::format("a rather long name {}", i), Membership::Shape::kGaussian, {0.1 * i, 0.05}, false, false});
  const std::string svg = drawing(FuzzyPartition(sets));
  static const std::regex label(R"rx(<text x="([-0-9.]+)" y="([-0-9.]+)"[^>]*>a rather long name)rx");
  std::vector<Eigen::Vector2d> places;
  for (std::sregex_iterator it(svg.begin(), svg.end(), label), end; it != end; ++it) places.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  REQUIRE(places.size() == 30);
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK((places[i].x() > 60 && places[i].x() < 840 && places[i].y() > 30));
    for (std::size_t k = 0; k < i; ++k) CHECK((places[i].y() != places[k].y() || std::abs(places[i].x() - places[k].x()) > 130));
  }
}

TEST_SUITE_END();
