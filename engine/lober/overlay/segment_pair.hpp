// Two segments, one of each curve, or both of one curve.
#pragma once

#include <compare>
#include <cstdint>

namespace lober {

/// A segment of the first curve and one of the second.
struct SegmentPair {
  std::uint32_t first;
  std::uint32_t second;
  friend auto operator<=>(const SegmentPair&, const SegmentPair&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace lober
