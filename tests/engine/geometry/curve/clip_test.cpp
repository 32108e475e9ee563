// Polygons cut to a rectangle, and cut_out outside of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "engine/geometry/curve/cut_outside.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
namespace {

constexpr Rectangle window{-1, -0.5, 1, 0.75};

// Crosses itself and the window often; some steps are longer than the window.
std::vector<Point> wanderer(std::uint32_t seed, std::size_t points) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-1, 1);
  std::vector<Point> curve{{step(random), step(random)}};
  while (curve.size() < points) {
    const double size = curve.size() % 7 == 0 ? 4 : 0.6;
    const Point last = curve.back();
    curve.push_back({0.9 * last.x + size * step(random), 0.9 * last.y + size * step(random)});
  }
  return curve;
}

// Winding numbers of a polygon, which may be the rest of one that lies elsewhere: nothing.
class Windings {
 public:
  explicit Windings(const std::vector<Point>& polygon) {
    if (polygon.size() > 2) index_.emplace(ClosedCurve::borrow(polygon));
  }
  [[nodiscard]] int about(Point at) const { return index_ ? winding(*index_, at).number : 0; }

 private:
  std::optional<IndexedCurve> index_;
};

TEST(Clip, WindingNumbersInsideStay) {
  int asked = 0, turned = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const std::vector<Point> whole = wanderer(seed, 40 + seed);
    const std::vector<Point> cut = clipped(whole, window), cut_out = detail::cut_outside(whole, window, 3);
    const Windings of_whole(whole), of_cut(cut), of_outside(cut_out);
    for (double x = -0.97; x < 1; x += 0.11) {
      for (double y = -0.47; y < 0.75; y += 0.13) {
        const int number = of_whole.about({x, y});
        EXPECT_EQ(of_cut.about({x, y}), number) << seed << ' ' << x << ' ' << y;
        EXPECT_EQ(of_outside.about({x, y}), number) << seed << ' ' << x << ' ' << y;
        ++asked;
        turned += number != 0;
      }
    }
  }
  EXPECT_GT(turned, asked / 10);
}

// A circle of many points of which the window sees a few.
TEST(Clip, KeepsWholeSegmentsThatMeetTheWindowAndTheirNeighbours) {
  std::vector<Point> circle;
  for (int k = 0; k < 1000; ++k) {
    const double t = 2 * 3.141592653589793 * k / 1000;
    circle.push_back({10 * std::cos(t) - 10.5, 10 * std::sin(t)});
  }
  const std::vector<Point> cut_out = detail::cut_outside(circle, window, 3);
  EXPECT_LT(cut_out.size(), 60U);
  const auto at = [&](std::size_t k) { return std::find(cut_out.begin(), cut_out.end(), circle[k]); };
  const auto first = at(997);  // the window ends at y = 0.75, after 12 segments
  ASSERT_NE(first, cut_out.end());
  for (std::size_t k = 0; k < 3 + 12 + 3; ++k) {
    ASSERT_NE(at((997 + k) % 1000), cut_out.end()) << k;
  }
  EXPECT_EQ(at(500), cut_out.end());
}

TEST(Clip, ClipsWholeWhatGoesRoundTheWindow) {
  const std::vector<Point> round{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
  const std::vector<Point> cut_out = detail::cut_outside(round, window, 3);
  const ClosedCurve whole = ClosedCurve::borrow(cut_out);
  EXPECT_EQ(signed_area(whole), 2 * 1.25);
}

}  // namespace
}  // namespace lober
