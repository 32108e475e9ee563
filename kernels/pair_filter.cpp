#include "kernels/pair_filter.hpp"

#include "kernels/cpu.hpp"
#include "kernels/predicates.hpp"
#include "kernels/simd.hpp"

#include "kernels/pair_filter.inl"

namespace lober::detail {

void filter_pairs_avx2(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                       PairVerdict* verdicts);

void filter_pairs(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                  PairVerdict* verdicts) {
  if (has_avx2()) {
    filter_pairs_avx2(first, second, pairs, count, verdicts);
  } else {
    filter(first, second, pairs, count, verdicts);
  }
}

}  // namespace lober::detail
