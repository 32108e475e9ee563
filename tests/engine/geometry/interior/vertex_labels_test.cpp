// Labels carried along the curve against a test of every vertex, on every family of pairs.
#include "lober/overlay/interior.hpp"
#include "tests/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kernels/predicates.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/oracle/families.hpp"

namespace lober::detail {
namespace {

// By definition, exactly: on a segment, or the parity of segments that a ray to the right crosses.
Side brute_force(Point point, const std::vector<Point>& curve) {
  PredicateCounts counts;
  bool inside = false;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Point a = curve[k], b = curve[k + 1 == curve.size() ? 0 : k + 1];
    if (on_segment(a, b, point, counts)) return Side::on;
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (orient2d(a, b, point, counts) == (b.y > a.y ? 1 : -1)) inside = !inside;
  }
  return inside ? Side::inside : Side::outside;
}

Buffer<Side> brute_force(const std::vector<Point>& points, const std::vector<Point>& curve) {
  Buffer<Side> labels;
  for (const Point& point : points) labels.push_back(brute_force(point, curve));
  return labels;
}

void expect_labels(const std::vector<Point>& first, const std::vector<Point>& second, const std::string& what) {
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  const Buffer<Side> labels1 = label_vertices(result.nodes, 1), labels2 = label_vertices(result.nodes, 2);
  EXPECT_EQ(labels1, brute_force(first, second)) << what << ", curve 1";
  EXPECT_EQ(labels2, brute_force(second, first)) << what << ", curve 2";
  EXPECT_EQ(labels1, label_points(IndexedCurve(CurveView{second}), first)) << what << ", curve 1 by queries";
  EXPECT_EQ(labels2, label_points(IndexedCurve(CurveView{first}), second)) << what << ", curve 2 by queries";
}

class VertexLabels : public testing::TestWithParam<oracle::Family> {};

TEST_P(VertexLabels, AgreeWithATestOfEveryVertex) {
  for (std::uint64_t seed = 0; seed < 100 && !HasFailure(); ++seed) {
    const oracle::CurvePair pair = oracle::make_curve_pair(GetParam(), seed);
    const std::string what = pair.family + " " + std::to_string(seed);
    expect_labels(pair.first, pair.second, what);
    std::vector<Point> reversed(pair.second.rbegin(), pair.second.rend());
    std::rotate(reversed.begin(), reversed.begin() + static_cast<std::ptrdiff_t>(seed % reversed.size()),
                reversed.end());
    expect_labels(pair.first, reversed, what + " reversed");
  }
}

INSTANTIATE_TEST_SUITE_P(Families, VertexLabels,
                         testing::ValuesIn(oracle::families().begin(), oracle::families().end()),
                         [](const auto& family) { return std::string(family.param.name); });

TEST(VertexLabels, ChangeTwiceAtASharedArc) {
  const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, shifted{{1, 0}, {3, 0}, {3, 1}, {1, 1}};
  const Overlay result = overlay(CurveView{square}, CurveView{shifted});
  const std::vector<SideChange> changes = side_changes(result.nodes, 1);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].point, (Point{1, 0}));
  EXPECT_EQ(changes[0].side, Side::on);
  EXPECT_EQ(changes[1].point, (Point{2, 0}));
  EXPECT_EQ(changes[1].side, Side::inside);
  EXPECT_EQ(changes[2].point, (Point{2, 1}));
  EXPECT_EQ(changes[2].side, Side::outside);
}

}  // namespace
}  // namespace lober::detail
