// The files that the programs of the field wrote (tests/corpus/make_formats.py), and the curves in them.
#pragma once

#include "curve_testing.hpp"
#include "lober/curve/formats.hpp"
#include "tests/paths.hpp"

namespace lober::test {

inline const std::vector<Point> first{{0, 0}, {1, 0.1}, {1.5, 1}, {0.1, 1.25}, {-0.3, 0.7}};

inline std::vector<Point> moved(std::vector<Point> points = first) {
  for (Point& point : points) point = {point.x + 2, point.y + 1};
  return points;
}

inline std::string corpus(const std::string& name) {
  return std::string(LOBER_SOURCE_DIR) + "/tests/corpus/formats/" + name;
}

// Skips, with the reason, where this build or machine has no library for the format.
#define REQUIRE_FORMAT(wanted)                                                          \
  for (const FormatInfo& info : formats()) {                                            \
    if (info.format == (wanted) && !info.missing.empty()) GTEST_SKIP() << info.missing; \
  }                                                                                     \
  static_assert(true)

inline CurveFile read_corpus(const std::string& name, const std::string& columns = {}) {
  return read_curve_file(corpus(name), {.columns = columns});
}

inline void expect_points(const Zone& zone, const std::vector<Point>& expected, double within = 0) {
  ASSERT_EQ(zone.points.size(), expected.size()) << zone.title;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(zone.points[k].x, expected[k].x, within) << zone.title << ' ' << k;
    EXPECT_NEAR(zone.points[k].y, expected[k].y, within) << zone.title << ' ' << k;
  }
}

}  // namespace lober::test
