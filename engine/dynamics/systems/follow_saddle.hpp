// A saddle on an axis of symmetry, followed from parameters where it is known to others (private to systems/).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "lober/base/error.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

struct FollowedSaddle {
  std::optional<FixedPoint> point;  ///< at the end of the way; none: lost
  double reached = 0;               ///< the part of the way on which it was found
};

/// The saddle on the axis y = 0 that the one near (x, 0) at the beginning of a way through the parameters, part 0, is
/// at its end, part 1. Newton's method needs a good guess next to orbits that nearly collide, and fails slowly: steps
/// of `longest_step`, halved where the saddle is lost or off by more than `longest_move` from where it was expected.
/// `map_at(part)` points to the map there.
template <typename MapAt>
FollowedSaddle follow_saddle(const MapAt& map_at, double x, double longest_step, double longest_move) {
  constexpr double on_axis = 1e-6;
  FollowedSaddle result;
  double slope = 0, step = longest_step;
  while (result.reached < 1 && step > longest_step / 200) {
    const double next = result.reached + step > 1 - 1e-9 ? 1 : result.reached + step;
    const double guess = x + slope * (next - result.reached);
    std::optional<FixedPoint> found;
    try {
      found = find_fixed_point(*map_at(next), {guess, 0});
    } catch (const DataError&) {  // none there
    }
    if (found && found->kind == FixedPointKind::saddle && std::fabs(found->at.y) < on_axis &&
        std::fabs(found->at.x - guess) < longest_move) {
      if (result.point) slope = (found->at.x - x) / (next - result.reached);
      x = found->at.x;
      step = std::min(2 * step, longest_step);
      result = {found, next};
    } else {
      step /= 2;
    }
  }
  if (result.reached < 1) result.point.reset();
  return result;
}

}  // namespace lober::detail
