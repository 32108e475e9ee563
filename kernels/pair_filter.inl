// Body of filter_pairs (kernels/all.inl).
#pragma once

#include "kernels/fours.inl"
#include "kernels/pair_filter.hpp"
#include "kernels/predicates.hpp"

namespace lober::detail {
namespace {

// The signs of a row of orient2d that are certain.
struct Signs {
  unsigned positive, negative;
};

inline Signs orientations(Widest ax, Widest ay, Widest bx, Widest by, Widest cx, Widest cy) {
  const Widest left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
  const Widest determinant = left - right;
  const Widest bound = splat_widest(orient2d_error) * (absolute(left) + absolute(right)) + splat_widest(orient2d_floor);
  return {mask_bits(less(bound, determinant)), mask_bits(less(bound, -determinant))};
}

// Which of as many pairs as there is room for are certainly apart, and which certainly cross.
struct PairBits {
  unsigned apart, to_left, to_right;
};
inline PairBits verdicts_of(const double* const* first, const double* const* second) {
  Widest p[4], q[4];
  load_fours(first, p);
  load_fours(second, q);
  const Signs c = orientations(p[0], p[1], p[2], p[3], q[0], q[1]);
  const Signs d = orientations(p[0], p[1], p[2], p[3], q[2], q[3]);
  const Signs a = orientations(q[0], q[1], q[2], q[3], p[0], p[1]);
  const Signs b = orientations(q[0], q[1], q[2], q[3], p[2], p[3]);
  const unsigned apart =
      (c.positive & d.positive) | (c.negative & d.negative) | (a.positive & b.positive) | (a.negative & b.negative);
  const unsigned across = (a.positive & b.negative) | (a.negative & b.positive);
  return {apart, c.negative & d.positive & across, c.positive & d.negative & across};
}

inline void filter_all_pairs(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                             PairVerdict* verdicts) {
  for (std::size_t begin = 0; begin < count; begin += widest) {
    const double* p[widest];
    const double* q[widest];
    unsigned wrapped = 0;
    const std::size_t together = count - begin < widest ? count - begin : widest;
    for (std::size_t k = 0; k < widest; ++k) {
      const SegmentPair pair = pairs[begin + (k < together ? k : 0)];
      const bool is_wrapped = pair.first >= first.first_wrapped || pair.second >= second.first_wrapped;
      wrapped |= static_cast<unsigned>(is_wrapped) << k;
      p[k] = &first.points[is_wrapped ? 0 : pair.first].x;
      q[k] = &second.points[is_wrapped ? 0 : pair.second].x;
    }
    const PairBits found = verdicts_of(p, q);
    // Verdicts are numbers from 0 to 3, of two bits each.
    static_assert(static_cast<int>(PairVerdict::apart) == 0 && static_cast<int>(PairVerdict::crosses_to_left) == 1 &&
                  static_cast<int>(PairVerdict::crosses_to_right) == 2 &&
                  static_cast<int>(PairVerdict::uncertain) == 3);
    const unsigned uncertain = wrapped | ~(found.apart | found.to_left | found.to_right);
    const unsigned low = found.to_left | uncertain, high = found.to_right | uncertain;
    for (std::size_t k = 0; k < together; ++k) {
      verdicts[begin + k] = static_cast<PairVerdict>((low >> k & 1U) | (high >> k & 1U) << 1U);
    }
  }
}

}  // namespace
}  // namespace lober::detail
