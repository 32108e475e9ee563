// Points inserted where labels change: how many, and that more of them bring the areas nearer, also where the curves
// share arcs exactly or to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "lober/overlay/interior.hpp"
#include "tests/oracle/random.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

// A curve of 29 points, and one of 79 that follows it along most of its sides, with points in between: exactly where a
// side is halved exactly, else beside it by the rounding of its points.
struct Shared {
  Points first = wavy_circle(29, 0.3, 5), second;
  Shared() {
    oracle::Random random(3);
    for (std::size_t k = 0; k < first.size(); ++k) {
      const Point a = first[k], b = first[(k + 1) % first.size()];
      const bool away = k % 7 == 0;
      second.push_back(away ? Point{0.9 * a.x, 0.9 * a.y} : a);
      if (away || k + 8 > first.size()) continue;
      for (const double t : {random.uniform(0.2, 0.4), random.uniform(0.5, 0.8)}) {
        second.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
  }
};

InteriorAreas by_ends(const Shared& curves, int passes, int points, std::size_t max_points = 1'000'000) {
  InteriorOptions options;
  options.method = InteriorMethod::ends;
  options.passes = passes;
  options.points = points;
  options.max_points = max_points;
  return interior_areas(CurveView{curves.first}, CurveView{curves.second}, options);
}

double distance_of(const Areas& x, const Areas& y) {
  return std::max(std::fabs(x.c1_minus_c2 - y.c1_minus_c2), std::fabs(x.c2_minus_c1 - y.c2_minus_c1));
}

TEST(Insertion, IsInProportionToTheChangesOfSide) {
  const Shared curves;
  const InteriorAreas exact = interior_areas(CurveView{curves.first}, CurveView{curves.second});
  const std::size_t changes = graph_of(exact.nodes).contacts.size();
  for (const int passes : {1, 2, 3, 5}) {
    const InteriorAreas found = by_ends(curves, passes, 100);
    // On each curve a change is looked for in one part a pass, or in two where it lies on a point between them.
    EXPECT_LE(found.statistics.points_inserted, 4 * changes * static_cast<std::size_t>(passes) * 100) << passes;
    EXPECT_GT(found.statistics.points_inserted, 0U);
  }
}

// (Where both ends of a segment lie on the other curve nothing is inserted, as in the article, so that the areas come
// near to those of the split curves, but not all the way.)
TEST(Insertion, MorePassesAreNeverWorse) {
  const Shared curves;
  const Areas exact = interior_areas(CurveView{curves.first}, CurveView{curves.second}).areas;
  double before = distance_of(by_ends(curves, 1, 100).areas, exact);
  for (const int passes : {2, 3, 4, 5}) {
    const double now = distance_of(by_ends(curves, passes, 100).areas, exact);
    EXPECT_LE(now, before + 1e-15) << passes;
    before = now;
  }
  EXPECT_LT(before, 0.1);
}

TEST(Insertion, StopsAtItsLimitAndNamesIt) {
  const Shared curves;
  const std::size_t inserted = by_ends(curves, 2, 50).statistics.points_inserted;
  EXPECT_NO_THROW((void)by_ends(curves, 2, 50, inserted + 79));
  try {
    (void)by_ends(curves, 2, 50, 500);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 500 points"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lober::test
