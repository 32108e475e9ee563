// A curve that a function knows, as a polygon whose distance from it meets a tolerance with nearly as few points as
// can be (private to dynamics/).
//
// A polygon through points of a smooth curve lies kappa h^2 / 8 off it (the sagitta; kappa the curvature, h the length
// of a segment). Where that is the tolerance e in every segment the polygon is optimally graded: it has the least
// number of points, the integral of sqrt(kappa / (8 e)) over the arc length. Halving segments until they are short
// enough wastes 44 % on average, so points are not halved into place: a guide, points that roughly resolve the curve,
// gives the density sqrt(kappa / 8 e) along it; points are placed evenly by that density, and what is then still too
// coarse, because the guide did not see it, is cut again, round by round.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "kernels/box.hpp"
#include "lober/base/buffer.hpp"
#include "lober/dynamics/manifolds.hpp"

namespace lober::detail {

/// Points at ascending parameters. A point that is not finite is one where the function fails.
struct Samples {
  Buffer<double> parameters;
  Buffer<Point> points;
};

/// Points beyond the ends, where the curve goes on without a corner: they show how it bends at the ends. Once points
/// are placed, nearer ones are taken where that costs little.
struct Beyond {
  std::optional<Point> before, behind;
  bool is_loop = false;             ///< the ends are one point, and these are those next to it
  bool function_goes_back = false;  ///< the function is defined before the first parameter too, down to half of it
};

/// Forgets those that have no coordinates.
void forget_unknown(Beyond& beyond);

struct TraceOptions {
  double tolerance = 0;
  double max_length = 0;
  double min_spacing = 0;  ///< parameters come no closer
  Box box;                 ///< only the part in it has to meet the tolerance
  std::size_t max_points = 0;
  bool cut = true;  ///< where points run out, the samples end there; else the trace is abandoned
  double max_total_length = std::numeric_limits<double>::infinity();  ///< the trace may end where it is this long
  std::uint32_t max_rounds = 40;
  std::size_t batch = 64;
  bool images_are_dear = true;                 ///< those that the guide has already are taken from there
  std::function<bool()> spent;                 ///< whether to give up, with Cancelled; asked by any thread
  std::function<void(std::size_t)> evaluated;  ///< called with the number of further evaluations; may throw to cancel
};

struct Trace {
  Samples samples;
  std::vector<std::uint32_t> kept;            ///< where the points that stayed are now
  std::vector<GrowthDiagnostic> diagnostics;  ///< segments of the samples, ascending; each one apart
  bool out_of_points = false;  ///< max_points was reached: the samples end where that was, or are worthless
  double points_needed = 0;    ///< points that an abandoned trace would need, about
};

/// Whether images after `steps` of a map are worth more than the way of finding those that a guide has already. A map
/// shows by its work whether it is given by a formula, once it has been used; about 12 steps of the standard map take
/// as long, more of a map without sines.
[[nodiscard]] inline bool are_dear(const PlanarMap& map, std::uint64_t steps) {
  return steps == 0 || steps >= 16 || map.work() > 0;
}

/// Points of the guide with the numbers `kept` (ascending, the first and the last among them) stay; the curve may have
/// corners there, at the first and the last if nothing is known beyond. Parallel; the same bits for any number of
/// threads. O(points) a round, few rounds.
[[nodiscard]] Trace traced(Samples guide, std::vector<std::uint32_t> kept, const Beyond& beyond,
                           const CurveFunction& function, const TraceOptions& options);

}  // namespace lober::detail
