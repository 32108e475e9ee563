// The number of parts that the segments of a polygon require to follow the curve through its points (private to
// dynamics/).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/dynamics/manifolds/trace.hpp"

namespace lober::detail {

/// No segment is cut into more parts at once: estimates that ask for more know too little.
inline constexpr double max_parts = 16;

struct TracedSegment {
  std::size_t number;
  double length;
  double curvature;       ///< the larger of those at its ends
  double required_parts;  ///< a real number; at most max_parts
  bool unknown;           ///< both ends are corners, so that nothing shows how the curve bends in between
  bool uneven;            ///< the curve is run through at a very different speed next to it: a fold may hide there
};

/// Segments begin .. end of the samples, at most `most` of them. Vertices `kept` are corners: there, and at the ends of
/// the samples, curvature is taken from the other end of the segment.
class SegmentRequirements {
 public:
  static constexpr std::size_t most = 256;
  void measure(const Samples& samples, std::span<const std::uint32_t> kept, const TraceOptions& options,
               std::size_t begin, std::size_t end);
  [[nodiscard]] TracedSegment operator[](std::size_t number) const {
    const std::size_t k = number - begin_;
    return {number, length_[k + 1], curvature_[k], required_parts_[k], unknown_[k] != 0, uneven_[k] != 0};
  }

 private:
  std::size_t begin_ = 0;
  std::array<double, most + 2> length_;  // from the segment before the first to the one behind the last
  std::array<double, most> curvature_, required_parts_;
  std::array<std::uint8_t, most> unknown_, uneven_;
};

}  // namespace lober::detail
