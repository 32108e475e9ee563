// Part of a curve on the section: an arc of trajectories of a tube or of a regularising curve (private to escape/).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kernels/elementary.hpp"

namespace lober::detail {

/// A map of [0, 1] to itself, slow at both ends: there cut curves wind about a tube, each turn in a fraction 1 /
/// multiplier of the rest.
inline constexpr double grading = 30;
[[nodiscard]] inline double graded(double t) {
  return t <= 0.5 ? 0.5 * elementary::expm1(2 * grading * t) / elementary::expm1(grading) : 1 - graded(1 - t);
}
[[nodiscard]] inline double ungraded(double g) {
  return g <= 0.5 ? elementary::log1p(2 * g * elementary::expm1(grading)) / (2 * grading) : 1 - ungraded(1 - g);
}

/// An arc of trajectories of a tube or a regularising curve.
struct TrajectoryArc {
  bool of_regularising_curve = false;
  std::size_t bottleneck = 0;
  int born = 0;  // regularising curves: the image at which they lay about X
  double from = 0, to = 1;
  bool graded_ends = false;

  [[nodiscard]] double at(double t) const {
    if (!graded_ends) return from + t * (to - from);
    return t <= 0.5 ? from + (to - from) * graded(t) : to - (to - from) * graded(1 - t);
  }
  [[nodiscard]] double parameter_of(double u) const {
    if (to == from) return 0;
    const double g = std::clamp((u - from) / (to - from), 0.0, 1.0), h = std::clamp((to - u) / (to - from), 0.0, 1.0);
    if (!graded_ends) return g;
    return g <= h ? ungraded(g) : 1 - ungraded(h);
  }
};

}  // namespace lober::detail
