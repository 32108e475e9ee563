// Exact predicates against GMP: signs must agree on everything finite, however degenerate.
#include "kernels/predicates.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

struct Triple {
  Point a, b, c;
};
struct TripleKind {
  const char* name;
  int tries;
  Triple (*make)(Random&);
};

Point any_point(Random& random) {
  return {any_finite(random), any_finite(random)};
}
Point point_with_exponent(Random& random, int low, int high) {
  return {with_exponent(random, low, high), with_exponent(random, low, high)};
}
Point unit_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1)};
}
Point lattice_point(Random& random, int size) {
  return {static_cast<double>(random.integer(-size, size)), static_cast<double>(random.integer(-size, size))};
}

// A point of line a b, rounded, and a few ulps away.
Point near_line(Random& random, Point a, Point b) {
  const double t = random.uniform(-1, 2);
  return neighbour(random, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, 2);
}

Triple bit_patterns(Random& random) {
  return {any_point(random), any_point(random), any_point(random)};
}
Triple ordinary(Random& random) {
  return {unit_point(random), unit_point(random), unit_point(random)};
}
Triple nearly_collinear(Random& random) {
  const Point a = unit_point(random), b = unit_point(random);
  return {a, b, near_line(random, a, b)};
}
Triple far_from_origin(Random& random) {
  const Point a{1e6 + random.unit(), -3e6 + random.unit()}, b{1e6 + random.unit(), -3e6 + random.unit()};
  return {a, b, near_line(random, a, b)};
}
Triple neighbours(Random& random) {
  const Point a = unit_point(random);
  return {a, neighbour(random, a, 3), neighbour(random, a, 3)};
}
Triple lattice(Random& random) {
  return {lattice_point(random, 6), lattice_point(random, 6), lattice_point(random, 6)};
}
Triple lattice_multiples(Random& random) {  // collinear, with a common factor that does not fit small integers
  const Point a = lattice_point(random, 1 << 20), step = lattice_point(random, 1 << 20);
  const int k = random.integer(-99, 99), m = random.integer(-99, 99);
  return {a, {a.x + k * step.x, a.y + k * step.y}, {a.x + m * step.x, a.y + m * step.y + random.integer(-1, 1)}};
}
Triple denormals(Random& random) {
  const auto value = [&] { return static_cast<double>(random.integer(-9, 9)) * 0x1p-1074; };
  return {{value(), value()}, {value(), value()}, {value(), value()}};
}
Triple tiny(Random& random) {
  const Point a = point_with_exponent(random, -545, -500), b = point_with_exponent(random, -545, -500);
  return {a, b, near_line(random, a, b)};
}
Triple huge(Random& random) {
  const Point a = point_with_exponent(random, 1020, 1023), b = point_with_exponent(random, 1020, 1023);
  return {a, b, neighbour(random, {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}, 2)};
}
Triple mixed_scales(Random& random) {
  const Point a = point_with_exponent(random, -60, 60), b = point_with_exponent(random, -60, 60);
  return {a, b, random.chance(0.5) ? near_line(random, a, b) : point_with_exponent(random, -60, 60)};
}
Triple with_equal_coordinates(Random& random) {
  const std::array<double, 3> values = {any_finite(random), any_finite(random), 0};
  const auto value = [&] { return values[random.index(3)]; };
  return {{value(), value()}, {value(), value()}, {value(), value()}};
}

constexpr std::array triple_kinds = {
    TripleKind{"bit patterns", 60000, bit_patterns},
    TripleKind{"ordinary", 200000, ordinary},
    TripleKind{"nearly collinear", 300000, nearly_collinear},
    TripleKind{"far from origin", 300000, far_from_origin},
    TripleKind{"neighbours", 200000, neighbours},
    TripleKind{"lattice", 200000, lattice},
    TripleKind{"lattice multiples", 200000, lattice_multiples},
    TripleKind{"denormals", 200000, denormals},
    TripleKind{"tiny", 100000, tiny},
    TripleKind{"huge", 100000, huge},
    TripleKind{"mixed scales", 200000, mixed_scales},
    TripleKind{"equal coordinates", 60000, with_equal_coordinates},
};

class Orient2d : public ::testing::TestWithParam<TripleKind> {};

TEST_P(Orient2d, EqualsTheExactSignAndObeysItsIdentities) {
  const TripleKind& kind = GetParam();
  Random random(seed());
  PredicateCounts counts;
  for (int k = 0; k < kind.tries; ++k) {
    const auto [a, b, c] = kind.make(random);
    const int expected = exact_orientation(a, b, c);
    const bool right = orient2d(a, b, c, counts) == expected && orient2d(b, c, a, counts) == expected &&
                       orient2d(c, a, b, counts) == expected && orient2d(b, a, c, counts) == -expected &&
                       orient2d(a, c, b, counts) == -expected && orient2d(c, b, a, counts) == -expected;
    ASSERT_TRUE(right) << std::hexfloat << "try " << k << ": " << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y << ' '
                       << c.x << ' ' << c.y << " expected " << expected;
  }
  RecordProperty("filter_failures", std::to_string(counts.filter_failures));
  RecordProperty("exact_calls", std::to_string(counts.exact_calls));
}

INSTANTIATE_TEST_SUITE_P(Kinds, Orient2d, ::testing::ValuesIn(triple_kinds), [](const auto& kind) {
  std::string name = kind.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(CrossSign, EqualsTheExactSign) {
  Random random(seed());
  PredicateCounts counts;
  int parallel = 0;
  for (const TripleKind& kind : triple_kinds) {
    for (int k = 0; k < kind.tries / 10; ++k) {
      const auto [a, b, c] = kind.make(random);
      const auto [d, e, f] = kind.make(random);
      // Directions of four points, of nearly one line, and of one and the same segment.
      for (const auto& [p, q] : {std::pair{c, d}, {b, c}, {a, b}, {c, b}, {d, e}}) {
        const int expected = exact_cross_sign(a, b, p, q);
        if (expected == 0) ++parallel;
        ASSERT_EQ(cross_sign(a, b, p, q, counts), expected) << kind.name << ", try " << k;
        ASSERT_EQ(cross_sign(p, q, a, b, counts), -expected) << kind.name << ", try " << k;
      }
    }
  }
  EXPECT_GT(parallel, 100000);
  EXPECT_GT(counts.exact_calls, 1000U);
}

TEST(Orient2dStages, EachIsReachedAndCounted) {
  PredicateCounts counts;
  orient2d({0, 0}, {1, 0}, {0, 1}, counts);
  EXPECT_EQ(counts.filter_failures, 0U) << "the filter decides";
  orient2d({0, 0}, {1, 1}, {3, 3}, counts);
  EXPECT_EQ(counts.filter_failures, 1U);
  EXPECT_EQ(counts.exact_calls, 0U) << "exact differences, exact products";
  orient2d({0, 0}, {0.1, 0.1}, {1e20, 1e20}, counts);
  EXPECT_EQ(counts.filter_failures, 2U);
  EXPECT_EQ(counts.exact_calls, 1U) << "differences that are not doubles";

  PredicateCounts sum = counts;
  sum += counts;
  EXPECT_EQ(sum.filter_failures, 4U);
  EXPECT_EQ(sum.exact_calls, 2U);
}

TEST(OnSegment, EqualsTheExactAnswer) {
  Random random(seed());
  PredicateCounts counts;
  int on = 0;
  for (int k = 0; k < 100000; ++k) {
    const bool coarse = random.chance(0.5);
    const Point a = coarse ? lattice_point(random, 4) : unit_point(random);
    const Point b = coarse ? lattice_point(random, 4) : unit_point(random);
    const Point p = coarse ? lattice_point(random, 4) : near_line(random, a, b);
    const auto between = [](double from, double to, double value) {
      return std::min(from, to) <= value && value <= std::max(from, to);
    };
    const bool expected = exact_orientation(a, b, p) == 0 && between(a.x, b.x, p.x) && between(a.y, b.y, p.y);
    ASSERT_EQ(on_segment(a, b, p, counts), expected) << "try " << k;
    on += expected ? 1 : 0;
  }
  EXPECT_GT(on, 1000);
}

}  // namespace
}  // namespace lober::test
