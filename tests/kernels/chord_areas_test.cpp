#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "kernels/sagitta.hpp"

namespace lober::detail {
namespace {

TEST(SagittaAreas, ManyAtOnceHaveTheBitsOfOneByOne) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> step(0, 1);
  for (const double scale : {1.0, 1e-150, 1e-170, 1e150}) {
    for (int round = 0; round < 50; ++round) {
      std::vector<Point> points(700);
      Point at{1, 2};
      double angle = 0;
      for (Point& point : points) {
        point = {scale * at.x, scale * at.y};
        angle += (round % 3 == 0 ? 2.0 : 0.1) * step(random);  // corners, or none
        const double length = random() % 20 == 0 ? 0 : 0.5 + 0.4 * std::sin(step(random));
        at = {at.x + length * std::cos(angle), at.y + length * std::sin(angle)};
      }
      const std::size_t count = points.size() - 3;
      std::vector<double> areas(count);
      twice_chord_areas(points.data(), count, areas.data());
      for (std::size_t k = 0; k < count; ++k) {
        const double one = twice_chord_area(points[k], points[k + 1], points[k + 2], points[k + 3]);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(areas[k]), std::bit_cast<std::uint64_t>(one)) << scale << ' ' << k;
      }
    }
  }
}

}  // namespace
}  // namespace lober::detail
