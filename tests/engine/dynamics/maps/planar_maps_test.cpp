// Properties of the planar map of every system: inverse, derivative, area, action, batches, symmetries.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "engine/dynamics/dynamics.hpp"
#include "kernels/box.hpp"
#include "kernels/cpu.hpp"
#include "lober/base/error.hpp"
#include "tests/paths.hpp"

namespace lober::detail {
namespace {

struct Sample {
  std::string name;
  ParameterValues values;
  bool preserves_area;
  Box where;
};

void PrintTo(const Sample& sample, std::ostream* out) {
  *out << sample.name;
}

Box sample_box(double x0, double y0, double x1, double y1) {
  return Box::of({x0, y0}, {x1, y1});
}

Point image(const PlanarMap& map, Point z, int iterates) {
  map.iterate({&z, 1}, iterates);
  return z;
}

double determinant_of(const Matrix2& a) {
  return a.xx * a.yy - a.xy * a.yx;
}

class EveryMap : public testing::TestWithParam<Sample> {
 protected:
  System system = make_system(GetParam().name, GetParam().values, {.tolerance = 1e-14});
  const PlanarMap& map = *system.map;

  /// Some points that have images and pre-images.
  std::vector<Point> points(std::size_t side = 4) const {
    const Box& where = GetParam().where;
    std::vector<Point> result;
    for (std::size_t k = 0; k < side * side; ++k) {
      const auto u = (static_cast<double>(k % side) + 0.37) / static_cast<double>(side);
      const auto v = (static_cast<double>(k / side) + 0.61) / static_cast<double>(side);
      result.push_back({where.min_x() + u * where.width(), where.min_y() + v * where.height()});
    }
    return result;
  }
};

TEST_P(EveryMap, InverseOfImageIsThePoint) {
  for (const Point z : points()) {
    const Point there = image(map, z, 1);
    ASSERT_FALSE(std::isnan(there.x)) << z.x << " " << z.y;
    EXPECT_LT(distance(image(map, there, -1), z), 2e-10) << z.x << " " << z.y;
  }
}

TEST_P(EveryMap, TwoIteratesAreTwiceOneInBits) {
  for (const Point z : points()) {
    EXPECT_EQ(image(map, z, 2), image(map, image(map, z, 1), 1));
  }
}

TEST_P(EveryMap, BatchesDoNotMatterInBits) {
  const std::vector<Point> from = points(7);
  std::vector<Point> together = from;
  map.iterate(together, 1);
  std::vector<Point> apart = from;
  for (std::size_t begin = 0, length = 1; begin < apart.size(); begin += length, length = 2 * length + 1) {
    map.iterate(std::span(apart).subspan(begin, std::min(length, apart.size() - begin)), 1);
  }
  EXPECT_EQ(together, apart);
  for (std::size_t k = 0; k < from.size(); ++k) EXPECT_EQ(image(map, from[k], 1), together[k]);
}

TEST_P(EveryMap, InstructionSetsDoNotMatterInBits) {
  const InstructionSet before = instruction_set();
  const auto results = [&] {
    std::vector<Point> images = points(5), moved = points(5);
    std::vector<Matrix2> derivatives(moved.size());
    map.iterate(images, -1);
    map.iterate_with_derivatives(moved, 2, derivatives);
    std::vector<double> numbers;
    for (std::size_t k = 0; k < images.size(); ++k) {
      const Matrix2& d = derivatives[k];
      for (const double number : {images[k].x, images[k].y, moved[k].x, moved[k].y, d.xx, d.xy, d.yx, d.yy})
        numbers.push_back(number);
    }
    return numbers;
  };
  const std::vector<double> best = results();
  for (const InstructionSet isa : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    limit_instruction_set(isa);
    const std::vector<double> here = results();
    EXPECT_EQ(std::memcmp(best.data(), here.data(), best.size() * sizeof(double)), 0) << static_cast<int>(isa);
  }
  limit_instruction_set(before);
}

TEST_P(EveryMap, DerivativesTogetherAreThoseApartInBits) {
  for (const int iterates : {-1, 1, 3}) {
    const std::vector<Point> from = points(3);
    std::vector<Point> together = from;
    std::vector<Matrix2> derivatives(from.size());
    map.iterate_with_derivatives(together, iterates, derivatives);
    for (std::size_t k = 0; k < from.size(); ++k) {
      Matrix2 d;
      EXPECT_EQ(map.iterate_with_derivative(from[k], iterates, d), together[k]);
      EXPECT_EQ(std::memcmp(&d, &derivatives[k], sizeof d), 0);
    }
  }
}

TEST_P(EveryMap, DerivativeIsThatOfDifferences) {
  for (const int iterates : {1, -1}) {
    for (const Point z : points(3)) {
      Matrix2 d;
      const Point there = map.iterate_with_derivative(z, iterates, d);
      EXPECT_LT(distance(there, image(map, z, iterates)), 1e-10);
      // Differences of fourth order; the step suits errors of some 1e-14 in the images.
      const double h = 1e-4;
      const auto difference = [&](double dx, double dy) {
        const Point a = image(map, {z.x + h * dx, z.y + h * dy}, iterates);
        const Point b = image(map, {z.x - h * dx, z.y - h * dy}, iterates);
        const Point c = image(map, {z.x + 2 * h * dx, z.y + 2 * h * dy}, iterates);
        const Point e = image(map, {z.x - 2 * h * dx, z.y - 2 * h * dy}, iterates);
        return Point{(8 * (a.x - b.x) - (c.x - e.x)) / (12 * h), (8 * (a.y - b.y) - (c.y - e.y)) / (12 * h)};
      };
      const Point dx = difference(1, 0), dy = difference(0, 1);
      const double size = std::abs(d.xx) + std::abs(d.xy) + std::abs(d.yx) + std::abs(d.yy);
      EXPECT_LT(distance(dx, {d.xx, d.yx}) + distance(dy, {d.xy, d.yy}), 1e-5 * size) << z.x << " " << z.y;
    }
  }
}

TEST_P(EveryMap, AreaIsPreserved) {
  if (!GetParam().preserves_area) GTEST_SKIP() << "a damped system";
  for (const Point z : points()) {
    Matrix2 d;
    map.iterate_with_derivative(z, 1, d);
    const double size = std::abs(d.xx * d.yy) + std::abs(d.xy * d.yx);
    EXPECT_LT(std::abs(determinant_of(d) - 1), 1e-12 * (1 + size)) << z.x << " " << z.y;
  }
}

TEST_P(EveryMap, ActionDiffersByTheIntegralOfYdx) {
  if (!GetParam().preserves_area) {
    EXPECT_FALSE(map.action({0.1, 0.1}, {0.1, 0.1}));
    return;
  }
  for (const Point z : points(3)) {
    const auto action = [&](Point from) { return static_cast<double>(*map.action(from, image(map, from, 1))); };
    Matrix2 d;
    const Point there = map.iterate_with_derivative(z, 1, d);
    const double h = 1e-4;
    const auto difference = [&](double dx, double dy) {
      return (8 * (action({z.x + h * dx, z.y + h * dy}) - action({z.x - h * dx, z.y - h * dy})) -
              (action({z.x + 2 * h * dx, z.y + 2 * h * dy}) - action({z.x - 2 * h * dx, z.y - 2 * h * dy}))) /
             (12 * h);
    };
    // dL = y' dx' - y dx
    EXPECT_NEAR(difference(1, 0), there.y * d.xx - z.y, 2e-5 * (1 + std::abs(there.y * d.xx)));
    EXPECT_NEAR(difference(0, 1), there.y * d.xy, 2e-5 * (1 + std::abs(there.y * d.xy)));
  }
}

TEST_P(EveryMap, ActionIsStationaryInTheEndOfAStep) {
  if (!GetParam().preserves_area) GTEST_SKIP() << "a damped system";
  const Point a = points(1)[0];
  const Point b = image(map, a, 1), c = image(map, b, 1);
  const auto sum = [&](Point middle) { return *map.action(a, middle) + *map.action(middle, c); };
  const double off = 1e-5;
  EXPECT_LT(std::abs(static_cast<double>(sum({b.x + off, b.y}) - sum({b.x - off, b.y})) / (2 * off)), 1e-5);
  EXPECT_LT(std::abs(static_cast<double>(sum({b.x, b.y + off}) - sum({b.x, b.y - off})) / (2 * off)), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(
    Systems, EveryMap,
    testing::Values(Sample{"standard", {{"K", 2}}, true, sample_box(-3, -3, 6, 3)},
                    Sample{"henon", {}, true, sample_box(-2, -2, 2, 2)},
                    Sample{"ovp", {}, true, sample_box(-1.8, 1.7, 1.8, 3)},
                    Sample{"ovp", {{"gamma", 1.81}, {"phase", 0.3}}, true, sample_box(-1.8, 1.9, 1.8, 3)},
                    Sample{"ovp1", {{"gamma", 1.2}}, true, sample_box(-1.8, 1.8, 1.8, 3)},
                    Sample{"duffing", {}, true, sample_box(-1.3, -0.8, 1.3, 0.8)},
                    Sample{"duffing", {{"delta", 0.2}, {"omega", 1.4}}, false, sample_box(-1, -0.8, 1, 0.8)},
                    Sample{"pendulum", {{"phase", 0.1}}, true, sample_box(-3, -1, 3, 1)},
                    Sample{"double-gyre", {{"eps", 0.25}}, true, sample_box(0.1, 0.1, 1.9, 0.9)},
                    Sample{"capsize", {{"energy", 0.24}}, true, sample_box(-0.2, -0.3, 0.2, 0.3)},
                    Sample{"pcr3bp", {}, true, sample_box(-2.2, -0.05, -1.9, 0.05)},
                    Sample{LOBER_EXAMPLES "/quadratic_map.so", {}, true, sample_box(-0.5, -0.5, 0.5, 0.5)},
                    Sample{LOBER_EXAMPLES "/henon_heiles.so", {}, true, sample_box(-0.2, -0.2, 0.3, 0.2)}));

// Where time runs backwards: (x, y) -> (-x, y) for the vortex pair at phase 0, (x, x') -> (x, -x') for the return maps.
TEST(Symmetry, TimeReversalConjugatesMapAndInverse) {
  struct Reversor {
    std::string name;
    Point z;
    double sx, sy;
  };
  for (const Reversor& r : {Reversor{"ovp", {0.7, 1.9}, -1, 1}, Reversor{"ovp1", {0.7, 2.1}, -1, 1},
                            Reversor{"pcr3bp", {-2.1, 0.03}, 1, -1}, Reversor{"capsize", {0.1, 0.2}, 1, -1},
                            Reversor{"duffing", {0.3, 0.4}, 1, -1}}) {
    const System system = make_system(r.name);
    const Point there = image(*system.map, r.z, 1);
    const Point back = image(*system.map, {r.sx * r.z.x, r.sy * r.z.y}, -1);
    EXPECT_LT(distance({r.sx * back.x, r.sy * back.y}, there), 3e-11) << r.name;
  }
}

TEST(Symmetry, TheLatticeOfALiftedMapCommutes) {
  for (const char* const name : {"standard", "pendulum", "abc"}) {
    const System system = make_system(name);
    const Point here = image(*system.map, {0.4, 0.7}, 1);
    const Point there = image(*system.map, {0.4 + system.lattice.x, 0.7 + system.lattice.y}, 1);
    EXPECT_LT(distance(there, {here.x + 2 * std::numbers::pi, here.y}), 1e-11) << name;
  }
}

TEST(LostPoints, BecomeNaN) {
  // To infinity, into the vortex' singularity, not reached by the energy, never back on the section, on it for ever.
  const std::array<std::pair<const char*, Point>, 5> lost{{{"henon", {1e200, 0}},
                                                           {"ovp1", {0.0, 1.0}},
                                                           {"capsize", {0.6, 0}},
                                                           {"pcr3bp", {-0.5, 0}},
                                                           {"capsize", {std::nan(""), 0}}}};
  for (const auto& [name, z] : lost) {
    const Point there = image(*make_system(name).map, z, 2);
    EXPECT_TRUE(std::isnan(there.x) && std::isnan(there.y)) << name;
  }
}

}  // namespace
}  // namespace lober::detail
