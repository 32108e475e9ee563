#include "lober/dynamics/fixed_points.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/text.hpp"
#include "engine/dynamics/fixed_points/displacement_grid.hpp"
#include "engine/dynamics/fixed_points/least_period.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;

namespace {

void require(const FixedPointOptions& options) {
  if (options.period < 1) throw UsageError("the period of a fixed point must be at least 1");
  if (options.turns != 0 && options.lattice == Point{}) {
    throw UsageError("the map of these fixed points does not repeat itself after a shift; turns have to be 0");
  }
  if (options.grid < 2) throw UsageError("the grid of a scan for fixed points must have at least 2 points a side");
}

}  // namespace

std::string_view name(FixedPointKind kind) {
  switch (kind) {
    case FixedPointKind::saddle:
      return "saddle";
    case FixedPointKind::inverse_saddle:
      return "inverse saddle";
    case FixedPointKind::reversing_saddle:
      return "saddle, orientation reversed";
    case FixedPointKind::centre:
      return "centre";
    case FixedPointKind::parabolic:
      return "parabolic";
    case FixedPointKind::attracting:
      return "attracting";
    case FixedPointKind::repelling:
      return "repelling";
  }
  return "";
}

FixedPoint find_fixed_point(const PlanarMap& map, Point guess, const FixedPointOptions& options) {
  require(options);
  const double reach = 0.5 * size_at(guess, options.extent);
  const NewtonEnd end = newton(map, guess, options, reach);
  if (!end.converged) {
    // Where a point of a smaller period is about to bifurcate, its own equation is the one that leads there.
    for (const FixedPointOptions& smaller : of_divisors(options)) {
      if (smaller.period == options.period || !is_finite(end.at)) break;
      const NewtonEnd there = newton(map, end.at, smaller, reach);
      if (there.converged) return describe(map, {&there.at, 1}, smaller)[0];
    }
    throw DataError("no point of period " + std::to_string(options.period) + " found from " + format_point(guess) +
                    (std::isfinite(end.residual) ? ": Newton's method ended at " + format_point(end.at) + ", off by " +
                                                       format_number(end.residual)
                                                 : ": it has no image under the map"));
  }
  return describe(map, {&end.at, 1}, options)[0];
}

FixedPointOptions detail::options_of_scan(const Rectangle& box, const FixedPointOptions& given) {
  require(given);
  if (!(box.width() > 0 && box.height() > 0)) throw UsageError("the box of a scan for fixed points is empty");
  FixedPointOptions options = given;
  options.extent = std::min(given.extent, extent_of(box));
  return options;
}

std::vector<FixedPoint> find_fixed_points(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& given) {
  const FixedPointOptions options = options_of_scan(box, given);
  const HalfWayMap half_way = half_way_map(map);
  std::vector<FixedPoint> result = scan(map, box, options, ScanGrids(map, half_way, box, options), half_way);
  add_points(result, scan_for_smaller_periods(map, box, options, half_way), options.extent);
  if (result.empty()) {
    const auto [point, least] = DisplacementGrid(map, box, options).nearest();
    throw DataError(
        "no point of period " + std::to_string(options.period) + " in [" + format_number(box.min_x) + ", " +
        format_number(box.max_x) + "] x [" + format_number(box.min_y) + ", " + format_number(box.max_y) + "]: " +
        (std::isnan(least) ? "no point of the box has an image"
                           : "the displacement is least, " + format_number(least) + ", at " + format_point(point)));
  }
  return result;
}

}  // namespace lober
