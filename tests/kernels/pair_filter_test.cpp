// Verdicts of the floating-point filter: never wrong, seldom uncertain, the same from both compiled copies.
#include "kernels/pair_filter.hpp"
#include "kernels/kernel_table.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/predicates.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"
#include "tests/shapes.hpp"

namespace lober::detail {}

namespace lober::test {
namespace {

struct FilterKind {
  const char* name;
  Point (*make)(Random&);
  double max_uncertain;
};
constexpr FilterKind filter_kinds[] = {
    {"ordinary",
     [](Random& random) {
       return Point{random.unit(), random.unit()};
     },
     0.05},
    {"lattice",
     [](Random& random) {
       return Point{1.0 * random.integer(0, 5), 1.0 * random.integer(0, 5)};
     },
     1},
    {"bit_patterns",
     [](Random& random) {
       return Point{any_finite(random), any_finite(random)};
     },
     1},
    {"nearly_collinear",
     [](Random& random) {
       return Point{random.unit(), neighbour(0.3, random.integer(-2, 2))};
     },
     1},
};

PairVerdict exact_verdict(Point a, Point b, Point c, Point d) {
  const int side_c = exact_orientation(a, b, c), side_d = exact_orientation(a, b, d);
  const int side_a = exact_orientation(c, d, a), side_b = exact_orientation(c, d, b);
  if (side_c * side_d > 0 || side_a * side_b > 0) return PairVerdict::apart;
  if (side_c * side_d == 0 || side_a * side_b == 0) return PairVerdict::uncertain;
  return side_d > 0 ? PairVerdict::crosses_to_left : PairVerdict::crosses_to_right;
}

struct FilterCase {
  Points first, second;
  std::vector<SegmentPair> pairs;
};
FilterCase make_filter_case(const FilterKind& kind, Random& random) {
  FilterCase made{Points(30), Points(40), {}};
  for (Point& point : made.first) point = kind.make(random);
  for (Point& point : made.second) point = kind.make(random);
  made.pairs.resize(random.index(50));
  for (SegmentPair& pair : made.pairs) {
    pair = {static_cast<std::uint32_t>(random.index(30)), static_cast<std::uint32_t>(random.index(40))};
  }
  return made;
}

class PairFilter : public ::testing::TestWithParam<FilterKind> {};

TEST_P(PairFilter, IsRightOrUncertain) {
  Random random(seed());
  std::size_t uncertain = 0, total = 0;
  for (int k = 0; k < 800; ++k) {
    const auto [first, second, pairs] = make_filter_case(GetParam(), random);
    std::vector<PairVerdict> verdicts(pairs.size());
    filter_pairs({first.data(), 29}, {second.data(), 39}, pairs.data(), pairs.size(), verdicts.data());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [s, t] = pairs[i];
      if (s == 29 || t == 39) {
        ASSERT_EQ(verdicts[i], PairVerdict::uncertain) << "a segment that wraps";
        continue;
      }
      ++total;
      if (verdicts[i] == PairVerdict::uncertain) {
        ++uncertain;
      } else {
        ASSERT_EQ(verdicts[i], exact_verdict(first[s], first[s + 1], second[t], second[t + 1])) << "try " << k;
      }
    }
  }
  EXPECT_LE(static_cast<double>(uncertain), GetParam().max_uncertain * static_cast<double>(total));
}

TEST_P(PairFilter, AllCopiesGiveTheSame) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 800; ++k) {
    const auto [first, second, pairs] = make_filter_case(GetParam(), random);
    std::vector<PairVerdict> plain(pairs.size()), wide(pairs.size());
    baseline_kernels.filter_pairs({first.data(), 29}, {second.data(), 39}, pairs.data(), pairs.size(), plain.data());
    for (const KernelTable* copy : vector_copies()) {
      copy->filter_pairs({first.data(), 29}, {second.data(), 39}, pairs.data(), pairs.size(), wide.data());
      ASSERT_EQ(plain, wide) << "try " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, PairFilter, ::testing::ValuesIn(filter_kinds),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace lober::test
