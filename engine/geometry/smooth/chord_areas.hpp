// Running sums of the chord-to-arc areas of a curve (private to smooth/).
#pragma once

#include <cstdint>
#include <span>

#include "engine/geometry/smooth/smooth_curve.hpp"
#include "kernels/double_double.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Twice the area between an arc of smooth curve and its polygon, positive to the right, and twice its error.
struct ChordArea {
  DD area;
  double error = 0;
};

/// Running sums along one curve, for any number of lists of segments, also of translates of the curve: kept at every
/// 16th segment.
class ChordAreaTable {
 public:
  /// O(n), parallel.
  explicit ChordAreaTable(const SmoothCurve& curve);
  [[nodiscard]] const ChordArea& total() const { return total_; }
  /// Segments of positive length that stay straight.
  [[nodiscard]] std::uint64_t fallbacks() const { return fallbacks_; }
  /// The areas of all segments before segments[k]; these ascend. O(segments asked for), parallel.
  [[nodiscard]] Buffer<ChordArea> before(const SmoothCurve& curve, std::span<const std::uint32_t> segments) const;

 private:
  Buffer<ChordArea> before_;
  ChordArea total_;
  std::uint64_t fallbacks_ = 0;
};

}  // namespace lober::detail
