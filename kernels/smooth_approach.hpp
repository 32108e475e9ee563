// Newton's iteration to where two smooth segments cross, and the areas there, many pairs side by side.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/point.hpp"
#include "kernels/smooth_segment.hpp"

namespace lober::detail {

/// Two points, one on each of two smooth curves, on their way to a crossing. Vertices and points have one origin, the
/// first end of the segment of C1 on which the polygons meet.
struct SmoothPair {
  enum class State : std::uint8_t {
    stays,    ///< where the polygons meet
    running,  ///< on its way
    outside,  ///< the last step leaves a segment
    tired,    ///< no steps are left
    met,      ///< at the crossing: the last step was below small_step in both parameters
  };
  struct Runner {
    double u;      ///< parameter on the segment
    Point vertex;  ///< first end of the segment
  };
  Runner on1, on2;
  Point polygons;                ///< where the polygons meet
  std::uint32_t shape1, shape2;  ///< numbers of the segments' shapes
  std::int16_t steps_left;
  bool rightward_to_left;  ///< whether the second curve is to pass from right to left
  bool small;              ///< whether the last step was below small_step
  State state;

  static constexpr std::int16_t max_steps = 30;
  static constexpr double small_step = 1e-13;
  /// A segment holds a little beyond its ends, so that a crossing at a vertex, where the two segments differ by less
  /// than they are wrong, is not chased to and fro.
  static constexpr double slack = 1e-6;
  [[nodiscard]] static bool leaves(double u) { return u < -slack || u > 1 + slack; }
};

/// Steps of Newton's iteration, at most one segment long, for the pairs of these numbers until none is running: the
/// same bits as SmoothSegment::at and velocity give, one by one. A pair that leaves a segment is `outside` with the
/// parameters beyond it; one stays where the curves do not cross in the wanted sense.
void approach_crossings(SmoothPair* pairs, const std::uint32_t* numbers, std::size_t count,
                        const SmoothSegment* shapes1, const SmoothSegment* shapes2);

/// The terms that one contact adds to the running sums of chord-to-arc areas before its two segments, so that they
/// reach the point where both curves pass; `uncertainty` is twice the area that may hide where the smooth curves do not
/// meet in that point, and the errors of the two segments.
struct EndOfArcs {
  double on1 = 0, on2 = 0;
  double uncertainty = 0;
};

/// Those of pairs that are on the segments where the polygons meet: at the first point of a pair that has met, else
/// where the polygons do.
void end_arcs(const SmoothPair* pairs, std::size_t count, const SmoothSegment* shapes1, const SmoothSegment* shapes2,
              EndOfArcs* ends);

}  // namespace lober::detail
