// The number of parts that the segments of a polygon require to follow the curve through its points (private to
// dynamics/).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/dynamics/manifolds/trace.hpp"
#include "kernels/segment_flags.hpp"

namespace lober::detail {

/// No segment is cut into more parts at once: estimates that ask for more know too little.
inline constexpr double max_parts = 16;
/// A segment is taken for too coarse when the estimate comes so close to the tolerance, because it is one.
inline constexpr double caution = 0.97;
/// The guide has at least this number of parts a segment, and turns by no more than this (radians).
inline constexpr double coarsest_guide = 5;
inline constexpr double sharpest_guide = 0.7;

struct TracedSegment {
  std::size_t number;
  double length;
  double curvature;       ///< the larger of those at its ends
  double required_parts;  ///< a real number; at most max_parts
  bool unknown;           ///< both ends are corners, so that nothing shows how the curve bends in between
  bool uneven;            ///< the curve is run through at a very different speed next to it: a fold may hide there
};

/// Segments begin .. end of the samples, at most `most` of them. Vertices `kept` are corners: there, and at the ends of
/// the samples if nothing is known beyond, curvature is taken from the other end of the segment.
class SegmentRequirements {
 public:
  static constexpr std::size_t most = max_flagged;
  /// Returns the flags that any of the segments has.
  std::int64_t measure(const Samples& samples, std::span<const std::uint32_t> kept, const Beyond& beyond,
                       const TraceOptions& options, std::size_t begin, std::size_t end);
  /// True only where `measure` would flag none of them as outside, uneven or coarse, whatever is kept; false where that
  /// is not sure. Most segments have none of these flags once points are placed, and this costs a third.
  [[nodiscard]] static bool surely_fine(const Samples& samples, const Beyond& beyond, const TraceOptions& options,
                                        std::size_t begin, std::size_t end);
  [[nodiscard]] TracedSegment operator[](std::size_t number) const {
    const std::size_t k = number - begin_;
    return {number,
            length_[k + 1],
            std::max({bend_[k], bend_[k + 1], 0.0}),
            required_parts_[k],
            (flags_[k] & unknown_segment) != 0,
            (flags_[k] & uneven_segment) != 0};
  }
  /// The flags of a segment (kernels/segment_flags.hpp).
  [[nodiscard]] std::int64_t flags(std::size_t number) const { return flags_[number - begin_]; }
  [[nodiscard]] double required_parts(std::size_t number) const { return required_parts_[number - begin_]; }

 private:
  std::size_t begin_ = 0;
  std::array<double, most + 2> length_;  // from the segment before the first to the one behind the last
  std::array<double, most + 1> bend_;    // at their points; negative at corners
  std::array<double, most> required_parts_;
  std::array<std::int64_t, most> flags_;
};

}  // namespace lober::detail
