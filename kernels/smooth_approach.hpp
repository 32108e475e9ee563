// Newton's iteration to where two smooth segments cross, many pairs side by side.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/point.hpp"
#include "kernels/smooth_segment.hpp"

namespace lober::detail {

/// Two points, one on each of two smooth curves, on their way to a crossing.
struct SmoothApproach {
  enum class State : std::uint8_t {
    running,  ///< on its way
    met,      ///< the last step was below small_step in both parameters
    away,     ///< the curves do not cross in the wanted sense where the points are
    outside,  ///< the last step leaves a segment
    tired,    ///< no steps are left
  };
  struct Runner {
    std::uint32_t shape;  ///< index of the segment's shape
    Point vertex;         ///< first end of the segment; both points have one origin
    double u;             ///< parameter on the segment
  };
  Runner on1, on2;
  std::int32_t steps_left;
  bool rightward_to_left;  ///< whether the second curve is to pass from right to left
  bool small;              ///< whether the last step was below small_step
  State state;

  static constexpr std::int32_t max_steps = 30;
  static constexpr double small_step = 1e-13;
  /// A segment holds a little beyond its ends, so that a crossing at a vertex, where the two segments differ by less
  /// than they are wrong, is not chased to and fro.
  static constexpr double slack = 1e-6;
  [[nodiscard]] static bool leaves(double u) { return u < -slack || u > 1 + slack; }
};

/// Steps of Newton's iteration, at most one segment long, until none is running: the same bits as SmoothSegment::at
/// and velocity give, one by one. A pair that leaves a segment is `outside` with the parameters beyond it.
void approach_crossings(SmoothApproach* pairs, std::size_t count, const SmoothSegment* shapes1,
                        const SmoothSegment* shapes2);

}  // namespace lober::detail
