// Every public function on curves, with curves that are open or closed and have no point, one or two: an answer that
// makes sense, or an exception that says what is wanted; never anything else.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/index/orientation.hpp"
#include "lober/curve/densify.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

enum class Wanted : std::uint8_t { closed, open, either };

// A function with its two curves, the second of which some do not need.
struct CurveFunction {
  const char* name;
  Wanted wanted;
  std::function<void(CurveView, CurveView)> call;
};

const Point somewhere{0.25, 0.25};

const std::vector<CurveFunction>& curve_functions() {
  static const std::vector<CurveFunction> all{
      {"overlay", Wanted::closed, [](CurveView a, CurveView b) { (void)overlay(a, b); }},
      {"overlay, second", Wanted::closed, [](CurveView a, CurveView b) { (void)overlay(b, a); }},
      {"overlay, indexed", Wanted::closed,
       [](CurveView a, CurveView b) { (void)overlay(IndexedCurve(a), IndexedCurve(b)); }},
      {"discretisation_error", Wanted::closed, [](CurveView a, CurveView) { (void)DiscretisationSums(a); }},
      {"interior_areas", Wanted::closed, [](CurveView a, CurveView b) { (void)interior_areas(a, b); }},
      {"interior_areas, second", Wanted::closed, [](CurveView a, CurveView b) { (void)interior_areas(b, a); }},
      {"interior_areas, indexed", Wanted::closed,
       [](CurveView a, CurveView b) { (void)interior_areas(IndexedCurve(a), IndexedCurve(b)); }},
      {"winding", Wanted::closed, [](CurveView a, CurveView) { (void)winding(IndexedCurve(a), somewhere); }},
      {"windings", Wanted::closed,
       [](CurveView a, CurveView) {
         (void)windings(IndexedCurve(a), {&somewhere, 1});
       }},
      {"interior_function", Wanted::closed,
       [](CurveView a, CurveView) { (void)interior_function(IndexedCurve(a), somewhere); }},
      {"interior_function, many", Wanted::closed,
       [](CurveView a, CurveView) {
         (void)interior_function(IndexedCurve(a), {&somewhere, 1});
       }},
      {"interior_function_direct", Wanted::closed,
       [](CurveView a, CurveView) { (void)interior_function_direct(a, somewhere); }},
      {"locate", Wanted::closed, [](CurveView a, CurveView) { (void)locate(IndexedCurve(a), somewhere); }},
      {"label_points", Wanted::closed,
       [](CurveView a, CurveView) {
         (void)label_points(IndexedCurve(a), {&somewhere, 1});
       }},
      {"contains", Wanted::closed, [](CurveView a, CurveView) { (void)contains(IndexedCurve(a), somewhere); }},
      {"orientation", Wanted::closed, [](CurveView a, CurveView) { (void)orientation(IndexedCurve(a)); }},
      {"regions of one", Wanted::closed, [](CurveView a, CurveView) { (void)regions(a); }},
      {"regions", Wanted::closed, [](CurveView a, CurveView b) { (void)regions(a, b); }},
      {"regions, second", Wanted::closed, [](CurveView a, CurveView b) { (void)regions(b, a); }},
      {"regions, indexed", Wanted::closed,
       [](CurveView a, CurveView b) { (void)regions(IndexedCurve(a), IndexedCurve(b)); }},
      {"smooth_area", Wanted::either, [](CurveView a, CurveView) { (void)smooth_area(a); }},
      {"common_area", Wanted::either, [](CurveView a, CurveView b) { (void)common_area(a, b); }},
      {"common_area, second", Wanted::either, [](CurveView a, CurveView b) { (void)common_area(b, a); }},
      {"tangle", Wanted::open, [](CurveView a, CurveView b) { (void)tangle(a, b); }},
      {"tangle, second", Wanted::open, [](CurveView a, CurveView b) { (void)tangle(b, a); }},
      {"tangle, indexed", Wanted::open,
       [](CurveView a, CurveView b) { (void)tangle(IndexedCurve(a), IndexedCurve(b)); }},
      {"signed_area", Wanted::either, [](CurveView a, CurveView) { (void)signed_area(a); }},
      {"validate", Wanted::either, [](CurveView a, CurveView) { validate(a, "curve"); }},
      {"require_simple", Wanted::either, [](CurveView a, CurveView) { (void)require_simple(IndexedCurve(a), 1); }},
      {"choose_index", Wanted::either,
       [](CurveView a, CurveView b) { (void)choose_index(IndexedCurve(a), IndexedCurve(b)); }},
      {"hobson_criteria", Wanted::either, [](CurveView a, CurveView) { (void)hobson_criteria(a); }},
      {"densify", Wanted::either,
       [](CurveView a, CurveView) {
         for (const Interpolation how : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline})
           (void)densify(a, {.max_length = 0.25}, {.interpolation = how});
       }},
      {"densify_near", Wanted::either, [](CurveView a, CurveView b) { (void)densify_near(a, b, {}); }},
      {"densify_near, other", Wanted::either, [](CurveView a, CurveView b) { (void)densify_near(b, a, {}); }},
      {"insert_crossings", Wanted::either, [](CurveView a, CurveView b) { (void)insert_crossings(a, b); }},
      {"simplify", Wanted::either, [](CurveView a, CurveView) { (void)simplify(a, {.tolerance = 0.1}); }},
  };
  return all;
}

// "nothing", "UsageError", "DataError"; other exceptions fail.
std::string outcome(const CurveFunction& function, CurveView a, CurveView b) {
  try {
    function.call(a, b);
  } catch (const UsageError& error) {
    EXPECT_GT(std::string_view(error.what()).size(), 10U);
    return "UsageError";
  } catch (const DataError& error) {
    EXPECT_GT(std::string_view(error.what()).size(), 10U);
    return "DataError";
  }
  return "nothing";
}

const std::vector<Point> unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Point> crossing_curve{{0.5, -1}, {0.75, 2}, {0.625, 3}, {0.5, 2}};

bool suits(Wanted wanted, bool closed) {
  return wanted == Wanted::either || (wanted == Wanted::closed) == closed;
}

TEST(OpenAndClosed, CurvesOfTheWrongKindAreRefused) {
  for (const CurveFunction& function : curve_functions()) {
    for (const bool closed : {false, true}) {
      const bool fits_second = function.wanted != Wanted::open;  // the second curve is of the kind that is wanted
      const std::string found = outcome(function, {unit_square, closed}, {crossing_curve, fits_second});
      EXPECT_EQ(found, suits(function.wanted, closed) ? "nothing" : "UsageError") << function.name << closed;
    }
  }
}

TEST(OpenAndClosed, CurvesOfHardlyAnyPointGiveAnAnswerOrAnError) {
  const std::vector<std::vector<Point>> small{{}, {{1, 2}}, {{1, 2}, {1, 2}}, {{0, 0}, {1, 1}}};
  for (const CurveFunction& function : curve_functions()) {
    for (const bool closed : {false, true}) {
      for (const std::vector<Point>& points : small) {
        const std::string found =
            outcome(function, {points, closed}, {crossing_curve, function.wanted != Wanted::open});
        if (!suits(function.wanted, closed) && points.size() > 1) {
          EXPECT_EQ(found, "UsageError") << function.name << " " << points.size();
        } else if (!suits(function.wanted, closed)) {
          EXPECT_NE(found, "nothing") << function.name << " " << points.size();
        }
      }
    }
  }
}

// Two curves with too few points for a region have none.
TEST(OpenAndClosed, RegionsNeedThreeDistinctVertices) {
  const std::vector<std::vector<Point>> small{{}, {{1, 2}}, {{0, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 0}, {1, 1}}};
  for (const CurveFunction& function : curve_functions()) {
    const std::string_view name = function.name;
    const bool of_regions = name.starts_with("overlay") || name.starts_with("interior_areas") ||
                            name.starts_with("regions") || name.starts_with("common_area") || name == "smooth_area" ||
                            name == "discretisation_error";
    if (!of_regions) continue;
    for (const std::vector<Point>& points : small) {
      EXPECT_EQ(outcome(function, {points}, {unit_square}), "DataError") << name << " " << points.size();
    }
  }
}

TEST(OpenAndClosed, TheMessageNamesTheCurveAndWhatIsWanted) {
  try {
    (void)regions(CurveView{unit_square}, CurveView{crossing_curve, false});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "curve 2 is open; regions needs closed curves");
  }
  try {
    (void)tangle(CurveView{unit_square, true}, CurveView{crossing_curve, false});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "U is closed; tangle needs open curves");
  }
}

}  // namespace
}  // namespace lober::test
