// The example of Tables 1 to 4 of Naik, Lekien & Ross (2017) (six crossings, two classes), on polygons made for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lober/overlay/overlay.hpp"
#include "tests/engine/geometry/overlay/six_crossings.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

std::vector<std::uint32_t> nodes_of(const Piece& piece) {
  return {piece.crossings.begin(), piece.crossings.end()};
}

TEST(Golden, TablesOneToFour) {
  const Overlay result = overlay(CurveView{six_crossings_c1}, CurveView{six_crossings_c2});
  ASSERT_EQ(result.nodes.size(), 6U);
  EXPECT_EQ(result.nodes.crossings(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(result.nodes[k].begin, (Point{static_cast<double>(k + 1), 0})) << "Table 1: order along C1";
    EXPECT_EQ(result.nodes[k].rho, k % 2 == 0 ? 1 : -1) << "Table 4";
  }
  // From the first vertex of C2 on, which lies just after crossing 1.
  const std::vector<std::uint32_t> order2(result.nodes.order2().begin(), result.nodes.order2().end());
  EXPECT_EQ(order2, (std::vector<std::uint32_t>{1, 4, 3, 2, 5, 0})) << "Table 2: order along C2";
  EXPECT_EQ(result.classes, (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 1})) << "Table 4";
  EXPECT_EQ(result.class_count, 2U);
}

TEST(Golden, SigmaAndAreas) {
  const Overlay result = overlay(CurveView{six_crossings_c1}, CurveView{six_crossings_c2});
  const Pieces& pieces = result.pieces(Pairing::c1_minus_c2);
  ASSERT_EQ(pieces.size(), 2U);
  // Table 3: sigma runs 1 -> 2 -> 1 and 3 -> 4 -> 5 -> 6 -> 3.
  EXPECT_EQ(nodes_of(pieces[0]), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(nodes_of(pieces[1]), (std::vector<std::uint32_t>{2, 3, 4, 5}));
  EXPECT_EQ(pieces[0].area, 1);
  EXPECT_EQ(pieces[1].area, 5);
  EXPECT_EQ(result.areas.c1_minus_c2, 6);
  EXPECT_EQ(result.areas.c1, 28);
  EXPECT_EQ(result.areas.intersection, 22);
}

TEST(Golden, EitherOrientation) {
  for (const bool reverse1 : {false, true}) {
    for (const bool reverse2 : {false, true}) {
      std::vector<Point> c1 = six_crossings_c1, c2 = six_crossings_c2;
      if (reverse1) std::reverse(c1.begin(), c1.end());
      if (reverse2) std::reverse(c2.begin(), c2.end());
      const Overlay result = overlay(CurveView{c1}, CurveView{c2});
      EXPECT_EQ(result.orientation1, reverse1 ? Orientation::clockwise : Orientation::counter_clockwise);
      for (std::size_t k = 0; k < 6; ++k) {
        const double x = reverse1 ? static_cast<double>(6 - k) : static_cast<double>(k + 1);
        EXPECT_EQ(result.nodes[k].begin, (Point{x, 0})) << "as C1 was given";
        EXPECT_EQ(result.nodes[k].rho, static_cast<int>(x) % 2 == 1 ? 1 : -1) << "of counter-clockwise curves";
      }
      EXPECT_EQ(result.class_count, 2U);
      EXPECT_EQ(result.areas.c1_minus_c2, 6);
    }
  }
}

}  // namespace
}  // namespace lober::test
