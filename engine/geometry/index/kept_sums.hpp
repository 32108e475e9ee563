// The shoelace sums of all segments of a short curve (private to the geometry).
//
// Those leaves of a long curve that hold a position are summed again (sums_along.hpp). A short curve meets many others
// as a rule, and then its leaves are summed hundreds of times: its box tree keeps these after some uses.
#pragma once

#include <cstddef>

#include "kernels/double_double.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class BoxTree;

class KeptSums {
  struct Sums {
    DD before, term;
  };

 public:
  /// Curves up to this number of segments are short.
  static constexpr std::size_t max_segments = 2048;

  /// O(N); 32 bytes a segment.
  explicit KeptSums(const BoxTree& tree);

  /// sum of cross(v_i - v_0, v_{i+1} - v_0) from the first vertex v_0 to t along the segment, in the bits of sum_along
  /// about v_0.
  [[nodiscard]] DD up_to(std::size_t segment, DD t) const {
    const auto& [before, term] = segments_[segment];
    const DD part = t * term, sum = two_sum(before.hi, part.hi);
    return fast_two_sum(sum.hi, sum.lo + (before.lo + part.lo));
  }
  /// Bytes for a curve of that number of segments.
  [[nodiscard]] static constexpr std::size_t memory(std::size_t segments) { return segments * sizeof(Sums); }
  /// The whole curve.
  [[nodiscard]] DD total() const { return total_; }

 private:
  Buffer<Sums> segments_;
  DD total_;
};

}  // namespace lober::detail
