// Two segments, one of each curve, or both of one curve.
#pragma once

#include <compare>
#include <cstdint>

namespace lober {

/// The number of a segment of the first curve and that of one of the second, or of two of one curve.
struct SegmentPair {
  std::uint32_t first;   ///< number of the segment of the first curve
  std::uint32_t second;  ///< number of the segment of the second curve
  /// The order by the first number, then by the second.
  friend auto operator<=>(const SegmentPair&, const SegmentPair&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace lober
