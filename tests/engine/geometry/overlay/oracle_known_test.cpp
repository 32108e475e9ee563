// Pairs with areas known in closed form or from elsewhere, for the oracle and for the engine. The first ones
// are those that Lober 1.8 gets wrong: shared sides, shared corners, a curve and itself.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "lober/overlay/overlay.hpp"
#include "tests/oracle/exact_overlay.hpp"
#include "tests/oracle/families.hpp"
#include "tests/oracle/judge.hpp"
#include "tests/oracle/trapezoid_area.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

using test::box;

struct Known {
  std::string name;
  Polygon first, second;
  double first_only, second_only;  // areas of A1 \ A2 and A2 \ A1
  std::size_t crossings, touches, shared_arcs;
  std::array<std::size_t, 4> pieces;  // per pairing
};

std::ostream& operator<<(std::ostream& stream, const Known& known) {
  return stream << known.name;
}

const std::vector<Known>& known_pairs() {
  static const std::vector<Known> pairs{
      {"square_in_rectangle_sharing_three_sides", box(0, 0, 1, 1), box(0, 0, 2, 1), 0, 1, 0, 0, 1, {0, 1, 1, 1}},
      {"aligned_squares_overlapping_by_half", box(0, 0, 1, 1), box(0.5, 0, 1.5, 1), 0.5, 0.5, 2, 0, 2, {1, 1, 1, 1}},
      {"rectangle_beside_square", box(0, 0, 1, 1), box(1, 0.25, 2, 0.75), 1, 0.5, 0, 0, 1, {1, 1, 0, 1}},
      {"plus_sign", box(0, 2, 6, 4), box(2, 0, 4, 6), 8, 8, 4, 0, 0, {2, 2, 1, 1}},
      {"itself", box(0, 0, 2, 2), {{2, 1}, {2, 0}, {1, 0}, {0, 0}, {0, 2}, {2, 2}}, 0, 0, 0, 0, 1, {0, 0, 1, 1}},
      {"corner_to_corner", box(0, 0, 1, 1), box(1, 1, 2, 2), 1, 1, 0, 1, 0, {1, 1, 0, 2}},
      {"corner_on_side_from_inside", box(0, 0, 2, 2), {{1, 0}, {1.5, 1}, {0.5, 1}}, 3.5, 0, 0, 1, 0, {1, 0, 1, 1}},
      // Two corners of the inner square on the sides of the outer one cut the ring in two.
      {"inner_square_touching_twice",
       box(0, 0, 2, 2),
       {{1, 0}, {1.5, 1}, {1, 2}, {0.5, 1}},
       3,
       0,
       0,
       2,
       0,
       {2, 0, 1, 1}},
      {"nested", box(0, 0, 3, 3), box(1, 1, 2, 2), 8, 0, 0, 0, 0, {1, 0, 1, 1}},
      {"apart", box(0, 0, 1, 1), box(2, 0, 3, 1), 1, 1, 0, 0, 0, {1, 1, 0, 2}},
      // The second curve closes the mouth of the first along two shared arcs: the bay becomes a hole.
      {"closed_bay",
       {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
       box(1, 2, 2, 3),
       7,
       1,
       0,
       0,
       2,
       {1, 1, 0, 1}},
  };
  return pairs;
}

class KnownOverlay : public testing::TestWithParam<Known> {};

TEST_P(KnownOverlay, Oracle) {
  const Known& known = GetParam();
  const ExactOverlay exact = exact_overlay(known.first, known.second);
  EXPECT_EQ(exact.areas[c1_minus_c2], known.first_only);
  EXPECT_EQ(exact.areas[c2_minus_c1], known.second_only);
  EXPECT_EQ(exact.crossings, known.crossings);
  EXPECT_EQ(exact.touches, known.touches);
  EXPECT_EQ(exact.shared_arcs, known.shared_arcs);
  for (std::size_t pairing = 0; pairing < 4; ++pairing) {
    EXPECT_EQ(exact.pieces[pairing].size(), known.pieces[pairing]) << "pairing " << pairing;
  }
}

TEST_P(KnownOverlay, Engine) {
  const Known& known = GetParam();
  const CurvePair pair{known.name, 0, known.first, known.second};
  EXPECT_EQ(try_pair(pair).complaints, "");
  const CurvePair exchanged{known.name, 1, known.second, known.first};
  EXPECT_EQ(try_pair(exchanged).complaints, "");
  const Overlay found = overlay(CurveView{known.first, true}, CurveView{known.second, true});
  EXPECT_EQ(found.areas.c1_minus_c2, known.first_only);
  EXPECT_EQ(found.areas.c2_minus_c1, known.second_only);
}

INSTANTIATE_TEST_SUITE_P(Pairs, KnownOverlay, testing::ValuesIn(known_pairs()),
                         [](const auto& member) { return member.param.name; });

TEST(KnownOverlayHoles, BayClosedAlongSharedArcs) {
  const Polygon cup{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const ExactOverlay exact = exact_overlay(cup, box(1, 2, 2, 3));
  ASSERT_EQ(exact.pieces[union_].size(), 1U);
  EXPECT_EQ(exact.pieces[union_][0].holes, 1U);
  EXPECT_EQ(exact.pieces[union_][0].area, 8);
}

TEST(KnownOverlayHoles, RingTouchedFromInsideHasNone) {
  // With one contact the inner square is still a hole, as the ring is joined round it; the ring has two ends
  // with two.
  const ExactOverlay once = exact_overlay(box(0, 0, 2, 2), Polygon{{1, 0}, {1.5, 1}, {0.5, 1}});
  ASSERT_EQ(once.pieces[c1_minus_c2].size(), 1U);
  EXPECT_EQ(once.pieces[c1_minus_c2][0].holes, 1U);
  const ExactOverlay twice = exact_overlay(box(0, 0, 2, 2), Polygon{{1, 0}, {1.5, 1}, {1, 2}, {0.5, 1}});
  ASSERT_EQ(twice.pieces[c1_minus_c2].size(), 2U);
  for (const ExactPiece& piece : twice.pieces[c1_minus_c2]) EXPECT_EQ(piece.holes, 0U);
}

Polygon regular(std::size_t corners, Point centre) {
  Polygon polygon;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    polygon.push_back({centre.x + std::cos(angle), centre.y + std::sin(angle)});
  }
  return polygon;
}

// Two unit circles as regular N-gons with a vertex at angle 0. The areas of A \ B were computed apart, by
// clipping the convex polygons against each other in floating point.
class KnownCircles : public testing::TestWithParam<std::pair<std::size_t, double>> {};

TEST_P(KnownCircles, OraclesAndEngine) {
  const auto [corners, area] = GetParam();
  const CurvePair pair{"circles", corners, regular(corners, {0, 0}), regular(corners, {1, 0.3})};
  const ExactOverlay exact = exact_overlay(pair.first, pair.second);
  EXPECT_NEAR(exact.areas[c1_minus_c2].get_d(), area, 1e-13);
  EXPECT_EQ(exact.areas[intersection], trapezoid_intersection(pair.first, pair.second));
  EXPECT_EQ(exact.crossings, 2U);
  EXPECT_EQ(judge(pair, exact, overlay(CurveView{pair.first, true}, CurveView{pair.second, true})).complaints, "");
}

INSTANTIATE_TEST_SUITE_P(Corners, KnownCircles,
                         testing::Values(std::pair<std::size_t, double>{1000, 1.9889083196085635},
                                         std::pair<std::size_t, double>{3000, 1.988914747146989},
                                         std::pair<std::size_t, double>{10000, 1.9889154777488769}));

}  // namespace
}  // namespace lober::oracle
