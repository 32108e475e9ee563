// Parameters of proper crossings: the bounds that kernels/crossing_parameters.hpp states, against GMP
// rationals.
#include "kernels/crossing_parameters.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/kernel_table.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"

namespace lober::detail {}

namespace lober::test {
namespace {

bool proper(const SegmentCrossing& x) {
  return exact_orientation(x.a, x.b, x.c) * exact_orientation(x.a, x.b, x.d) < 0 &&
         exact_orientation(x.c, x.d, x.a) * exact_orientation(x.c, x.d, x.b) < 0;
}

SegmentCrossing steep(Random& random) {
  const auto point = [&] { return Point{random.uniform(-1, 1), random.uniform(-1, 1)}; };
  return {point(), point(), point(), point()};
}
SegmentCrossing far_away(Random& random) {
  const auto point = [&] { return Point{1e5 + random.uniform(-1, 1), -2e5 + random.uniform(-1, 1)}; };
  return {point(), point(), point(), point()};
}
SegmentCrossing nearly_parallel(Random& random) {
  const double angle = random.log_uniform(1e-17, 1e-3), shift = random.uniform(-1, 1);
  const Point a{random.uniform(-1, 1), random.uniform(-1, 1)}, b{random.uniform(-1, 1), random.uniform(-1, 1)};
  const double dx = b.x - a.x, dy = b.y - a.y;
  return {a,
          b,
          {a.x + shift * 0.1 * dx - angle * dy, a.y + shift * 0.1 * dy + angle * dx},
          {b.x + angle * dy, b.y - angle * dx}};
}
// Angles down to 1e-300: along an axis coordinates across it can be as small as they like.
SegmentCrossing parallel_to_an_axis(Random& random) {
  const auto across = [&] { return random.log_uniform(1e-300, 1e-2); };
  const double ya = across(), yc = across();
  const SegmentCrossing x{{0, ya}, {random.uniform(0.5, 1), -across()}, {random.uniform(0, 0.5), -yc}, {1, across()}};
  if (random.chance(0.5)) return x;
  return {{x.a.y, x.a.x}, {x.b.y, x.b.x}, {x.c.y, x.c.x}, {x.d.y, x.d.x}};
}
SegmentCrossing of_different_lengths(Random& random) {
  SegmentCrossing x = steep(random);
  const double t = random.unit(), size = random.log_uniform(1e-12, 1);
  const Point on{x.a.x + t * (x.b.x - x.a.x), x.a.y + t * (x.b.y - x.a.y)};
  x.c = {on.x + size * x.c.x, on.y + size * x.c.y};
  x.d = {on.x + size * x.d.x, on.y + size * x.d.y};
  return x;
}

struct CrossingKind {
  const char* name;
  SegmentCrossing (*make)(Random&);
};
constexpr std::array crossing_kinds = {CrossingKind{"steep", steep}, CrossingKind{"far_away", far_away},
                                       CrossingKind{"nearly_parallel", nearly_parallel},
                                       CrossingKind{"parallel_to_an_axis", parallel_to_an_axis},
                                       CrossingKind{"of_different_lengths", of_different_lengths}};

std::vector<SegmentCrossing> make_crossings(const CrossingKind& kind, std::size_t wanted, double size) {
  Random random(seed());
  std::vector<SegmentCrossing> result;
  for (int k = 0; k < 400000 && result.size() < wanted; ++k) {
    SegmentCrossing x = kind.make(random);
    for (Point* point : {&x.a, &x.b, &x.c, &x.d}) *point = {point->x * size, point->y * size};
    if (proper(x)) result.push_back(x);
  }
  return result;
}

mpq_class cross_of(const ExactVector& u, const ExactVector& v) {
  return u.x * v.y - u.y * v.x;
}

void expect_bounds(const std::vector<SegmentCrossing>& crossings, double scale) {
  std::vector<CrossingParameters> parameters(crossings.size());
  crossing_parameters(crossings.data(), crossings.size(), scale, parameters.data());
  const mpq_class uncertainty = power_of_two(-62), gap = power_of_two(-91) * mpq_class(scale);
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const auto& [a, b, c, d] = crossings[k];
    const ExactVector u = exact_vector(a, b), v = exact_vector(c, d), w = exact_vector(a, c);
    const mpq_class below = cross_of(u, v), t1 = value_of(parameters[k].t1), t2 = value_of(parameters[k].t2);
    ASSERT_LE(abs(mpq_class(t1 - cross_of(w, v) / below)), uncertainty) << "crossing " << k;
    ASSERT_LE(abs(mpq_class(t2 - cross_of(w, u) / below)), uncertainty) << "crossing " << k;
    const mpq_class gap_x = t1 * u.x - t2 * v.x - w.x, gap_y = t1 * u.y - t2 * v.y - w.y;
    ASSERT_LT(gap_x * gap_x + gap_y * gap_y, gap * gap) << "crossing " << k;
  }
}

class CrossingParametersOf : public ::testing::TestWithParam<CrossingKind> {};

TEST_P(CrossingParametersOf, KeepTheirBounds) {
  const bool far = std::strcmp(GetParam().name, "far_away") == 0;
  for (const double size : {1.0, 1e-9, 1e12}) {
    const auto crossings = make_crossings(GetParam(), 2001, size);
    ASSERT_GT(crossings.size(), 100U);
    expect_bounds(crossings, far ? 4e5 * size : 4 * size);
    expect_bounds({crossings.begin(), crossings.begin() + 3}, 4 * size);
    expect_bounds(crossings, 1e12 * size);  // small in a large scene: only the parameters count
  }
}

TEST_P(CrossingParametersOf, AreTheSameBitsFromAllCopies) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  const auto crossings = make_crossings(GetParam(), 2000, 1);
  for (std::size_t k = 0; k + eight <= crossings.size(); k += eight) {
    std::array<CrossingParameters, eight> plain, wide;
    const unsigned shallow = baseline_kernels.eight_parameters(&crossings[k], 4, plain.data());
    for (const KernelTable* copy : vector_copies()) {
      ASSERT_EQ(shallow, copy->eight_parameters(&crossings[k], 4, wide.data()));
      for (std::size_t i = 0; i < eight; ++i) {
        if ((shallow >> i & 1U) != 0) continue;  // computed exactly instead
        ASSERT_EQ(std::memcmp(&plain[i], &wide[i], sizeof plain[i]), 0) << "crossing " << k + i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CrossingParametersOf, ::testing::ValuesIn(crossing_kinds),
                         [](const auto& kind) { return kind.param.name; });

TEST(CrossingParameters, ShallowOnesAreComputedExactlyAndCounted) {
  const SegmentCrossing steep_one{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
  const SegmentCrossing shallow_one{{0, 0}, {1, 0}, {0.25, -1e-300}, {0.75, 1e-300}};
  std::array<SegmentCrossing, 6> crossings;
  crossings.fill(steep_one);
  crossings[2] = crossings[5] = shallow_one;
  std::array<CrossingParameters, 6> parameters;
  EXPECT_EQ(crossing_parameters(crossings.data(), 6, 1, parameters.data()), 2U);
  for (const CrossingParameters& parameter : parameters) {
    EXPECT_EQ(parameter.t1.hi, 0.5);
    EXPECT_EQ(parameter.t2.hi, 0.5);
  }
}

}  // namespace
}  // namespace lober::test
