// Cases of public trackers that polygon libraries get wrong: lober has the exact areas, to the bar that it prints, for
// both orders of the curves, either orientation and any first vertex.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "kernels/box.hpp"
#include "lober/curve/files.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "tests/oracle/cgal_overlay.hpp"
#include "tests/paths.hpp"
#include "tests/trust/exact_case.hpp"

namespace lober::trust {

// For the names of tests.
inline std::ostream& operator<<(std::ostream& stream, const TrackerCase& given) {
  return stream << given.tracker;
}

namespace {

using oracle::Rational;

const std::vector<TrackerCase>& all_tracker_cases() {
  static const std::vector<TrackerCase> cases = tracker_cases(LOBER_SOURCE_DIR "/tests/corpus/trackers");
  return cases;
}

std::array<double, area_count> in_order(const Areas& areas) {
  return {areas.c1, areas.c2, areas.c1_minus_c2, areas.c2_minus_c1, areas.intersection, areas.union_};
}

// The areas of the curves in the other order.
template <class Number>
std::array<Number, area_count> exchanged(std::array<Number, area_count> areas) {
  std::swap(areas[area_c1], areas[area_c2]);
  std::swap(areas[area_c1_minus_c2], areas[area_c2_minus_c1]);
  return areas;
}

Ring backwards(Ring curve) {
  std::reverse(curve.begin(), curve.end());
  return curve;
}
Ring from_the_middle(Ring curve) {
  std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(curve.size() / 2), curve.end());
  return curve;
}

struct Arrangement {
  std::string name;
  Ring first, second;
  std::array<Rational, area_count> exact;
};

std::vector<Arrangement> arrangements(const ExactCase& given) {
  std::vector<Arrangement> result;
  for (const bool exchange : {false, true}) {
    const Ring& first = exchange ? given.c2 : given.c1;
    const Ring& second = exchange ? given.c1 : given.c2;
    const auto exact = exchange ? exchanged(given.areas) : given.areas;
    const std::string order = exchange ? "C2, C1" : "C1, C2";
    result.push_back({order, first, second, exact});
    result.push_back({order + ", first backwards", backwards(first), second, exact});
    result.push_back({order + ", second backwards", first, backwards(second), exact});
    result.push_back({order + ", both backwards", backwards(first), backwards(second), exact});
    result.push_back({order + ", first from its middle", from_the_middle(first), second, exact});
    result.push_back({order + ", second from its middle", first, from_the_middle(second), exact});
  }
  return result;
}

// The area of the box around both curves.
double box_area(const ExactCase& given) {
  const detail::Box box = detail::union_of(detail::box_of(given.c1), detail::box_of(given.c2));
  return box.width() * box.height();
}

void expect_areas(const Areas& found, const Areas& bars, const std::array<Rational, area_count>& exact, double box) {
  for (std::size_t k = 0; k < area_count; ++k) {
    const double area = in_order(found)[k], bar = in_order(bars)[k];
    const Rational error = abs(Rational(area) - exact[k]);
    EXPECT_LE(error, Rational(bar)) << area_names[k] << " is " << area << " +- " << bar << ", exactly "
                                    << digits(exact[k]);
    EXPECT_LE(Rational(bar), exact[k] * Rational(1e-14) + Rational(1e-24 * box))
        << area_names[k] << ": a bar that says little";
  }
}

class TrackerCases : public testing::TestWithParam<TrackerCase> {
 protected:
  TrackerCases() : exact_(exact_case(GetParam())) {}
  const ExactCase exact_;
};

// A change of anything in a file is found, and the file of a new case is written by tracker_corpus.
TEST_P(TrackerCases, FileIsWhatItsPolygonsGive) {
  EXPECT_EQ(case_text(GetParam(), exact_), GetParam().text) << "tracker_corpus FILE... writes it";
  const CurveFile file = read_curve_file(LOBER_SOURCE_DIR "/tests/corpus/trackers/" + GetParam().name + ".dat");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[0].points, exact_.c1);
  EXPECT_EQ(file.zones[1].points, exact_.c2);
}

TEST_P(TrackerCases, OraclesAgree) {
  // Trapezoids see the product of both winding numbers, which are 1 or -1 inside.
  EXPECT_EQ(abs(exact_.intersection_by_trapezoids), exact_.areas[area_intersection]);
  if (!exact_.simple) return;
  const oracle::CgalOverlay overlay = oracle::cgal_overlay(exact_.c1, exact_.c2);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(overlay.areas[k], exact_.areas[area_c1_minus_c2 + k]) << area_names[k + 2];
}

TEST_P(TrackerCases, OverlayHasTheExactAreas) {
  for (const Arrangement& arrangement : arrangements(exact_)) {
    SCOPED_TRACE(arrangement.name);
    const ClosedCurve first = ClosedCurve::borrow(arrangement.first), second = ClosedCurve::borrow(arrangement.second);
    if (exact_.simple) {
      const Overlay result = overlay(first, second);
      expect_areas(result.areas, result.rounding, arrangement.exact, box_area(exact_));
    } else {
      EXPECT_THROW(static_cast<void>(overlay(first, second)), NotSimpleError) << "rings joined by a way there and back";
    }
  }
}

TEST_P(TrackerCases, RegionsHaveTheExactAreas) {
  for (const Arrangement& arrangement : arrangements(exact_)) {
    SCOPED_TRACE(arrangement.name);
    const Regions result = regions(ClosedCurve::borrow(arrangement.first), ClosedCurve::borrow(arrangement.second));
    for (const FillRule rule : {FillRule::nonzero, FillRule::evenodd}) {
      expect_areas(result.areas(rule), result.rounding(rule), arrangement.exact, box_area(exact_));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, TrackerCases, testing::ValuesIn(all_tracker_cases()), [](const auto& given) {
  std::string name = given.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace lober::trust
