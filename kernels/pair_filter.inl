// Body of filter_pairs (kernels/all.inl).
#pragma once

#include "kernels/pair_filter.hpp"
#include "kernels/predicates.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// Lanes of orient2d: which are certainly positive and which certainly negative.
struct Signs {
  unsigned positive, negative;
};

inline Signs orientations(Lanes ax, Lanes ay, Lanes bx, Lanes by, Lanes cx, Lanes cy) {
  const Lanes left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
  const Lanes determinant = left - right;
  const Lanes bound = splat(orient2d_error) * (absolute(left) + absolute(right)) + splat(orient2d_floor);
  return {mask_bits(determinant > bound), mask_bits(-determinant > bound)};
}

inline void verdicts_of_four(const Point* const (&first)[lanes], const Point* const (&second)[lanes],
                             PairVerdict* verdicts) {
  Lanes p[lanes], q[lanes];
  for (std::size_t k = 0; k < lanes; ++k) {
    p[k] = load(&first[k]->x);
    q[k] = load(&second[k]->x);
  }
  transpose(p);
  transpose(q);
  const Signs c = orientations(p[0], p[1], p[2], p[3], q[0], q[1]);
  const Signs d = orientations(p[0], p[1], p[2], p[3], q[2], q[3]);
  const Signs a = orientations(q[0], q[1], q[2], q[3], p[0], p[1]);
  const Signs b = orientations(q[0], q[1], q[2], q[3], p[2], p[3]);
  const unsigned apart =
      (c.positive & d.positive) | (c.negative & d.negative) | (a.positive & b.positive) | (a.negative & b.negative);
  const unsigned across = (a.positive & b.negative) | (a.negative & b.positive);
  const unsigned to_left = c.negative & d.positive & across, to_right = c.positive & d.negative & across;
  for (std::size_t k = 0; k < lanes; ++k) {
    const unsigned bit = 1U << k;
    verdicts[k] = (apart & bit) != 0      ? PairVerdict::apart
                  : (to_left & bit) != 0  ? PairVerdict::crosses_to_left
                  : (to_right & bit) != 0 ? PairVerdict::crosses_to_right
                                          : PairVerdict::uncertain;
  }
}

inline void filter_all_pairs(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                             PairVerdict* verdicts) {
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const Point* p[lanes];
    const Point* q[lanes];
    bool wrapped[lanes];
    PairVerdict four[lanes];
    const std::size_t together = count - begin < lanes ? count - begin : lanes;
    for (std::size_t k = 0; k < lanes; ++k) {
      const SegmentPair pair = pairs[begin + (k < together ? k : 0)];
      wrapped[k] = pair.first >= first.first_wrapped || pair.second >= second.first_wrapped;
      p[k] = first.points + (wrapped[k] ? 0 : pair.first);
      q[k] = second.points + (wrapped[k] ? 0 : pair.second);
    }
    verdicts_of_four(p, q, four);
    for (std::size_t k = 0; k < together; ++k) verdicts[begin + k] = wrapped[k] ? PairVerdict::uncertain : four[k];
  }
}

}  // namespace
}  // namespace lober::detail
