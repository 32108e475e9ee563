// Two segments, one of each curve, or both of one curve.
#pragma once

#include <compare>
#include <cstdint>

namespace lober {

/// The number of a segment of the first curve and that of one of the second, or of two of one curve.
struct SegmentPair {
  std::uint32_t first;
  std::uint32_t second;
  friend auto operator<=>(const SegmentPair&, const SegmentPair&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace lober
