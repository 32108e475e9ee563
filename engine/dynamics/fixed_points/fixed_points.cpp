#include "lober/dynamics/fixed_points.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/fixed_points/classify.hpp"
#include "engine/dynamics/fixed_points/displacement_grid.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;

namespace {

void require(const FixedPointOptions& options) {
  if (options.period < 1) throw UsageError("the period of a fixed point must be at least 1");
  if (options.grid < 2) throw UsageError("the grid of a scan for fixed points must have at least 2 points a side");
}

FixedPoint describe(const PlanarMap& map, Point at, const FixedPointOptions& options) {
  FixedPoint result;
  result.at = at;
  for (int period = 1; period <= options.period; ++period) {
    if (options.period % period != 0) continue;
    const double share = static_cast<double>(period) / options.period;
    const Displacement here = displacement(map, at, period, {share * options.shift.x, share * options.shift.y});
    if (period < options.period && !(length(here.gap) <= 1e-8 * size_at(at, options.extent))) continue;
    result.period = period;
    result.derivative = here.derivative;
    result.residual = length(here.gap);
    break;
  }
  classify(result);
  return result;
}

bool in_box(const Rectangle& box, Point z) {
  const double slack = 1e-9 * size_at({box.width(), box.height()}, extent_of(box));
  return box.min_x - slack <= z.x && z.x <= box.max_x + slack && box.min_y - slack <= z.y && z.y <= box.max_y + slack;
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
  const NewtonEnd end = newton(map, guess, options, 0.5 * size_at(guess, options.extent));
  if (!end.converged) {
    throw DataError("no point of period " + std::to_string(options.period) + " found from " + format_point(guess) +
                    (std::isfinite(end.residual) ? ": Newton's method ended at " + format_point(end.at) + ", off by " +
                                                       format_number(end.residual)
                                                 : ": it has no image under the map"));
  }
  return describe(map, end.at, options);
}

std::vector<FixedPoint> detail::scan(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& wanted,
                                     const DisplacementGrid& grid, const SearchAllowance* allowance) {
  FixedPointOptions options = wanted;
  options.extent = std::min(wanted.extent, extent_of(box));
  const std::vector<Point> seeds = grid.seeds();
  std::vector<std::optional<FixedPoint>> found(seeds.size());
  // Whether there is work left is asked between rounds, so that it does not depend on threads.
  constexpr std::size_t seeds_a_task = 16, seeds_a_round = 32;
  for (std::size_t round = 0; round < seeds.size() && (!allowance || allowance->has(0)); round += seeds_a_round) {
    for_each_block(std::min(seeds_a_round, seeds.size() - round), seeds_a_task,
                   [&](std::size_t begin, std::size_t end) {
                     const auto some = std::span(seeds).subspan(round + begin, end - begin);
                     const std::vector<NewtonEnd> ends = newton(map, some, options, 2 * grid.cell());
                     for (std::size_t k = 0; k < ends.size(); ++k) {
                       if (!ends[k].converged || !in_box(box, ends[k].at)) continue;
                       found[round + begin + k] = describe(map, ends[k].at, options);
                     }
                   });
  }
  std::vector<FixedPoint> result;
  for (const std::optional<FixedPoint>& point : found) {
    if (!point) continue;
    const auto same = std::find_if(result.begin(), result.end(), [&](const FixedPoint& other) {
      return length({other.at.x - point->at.x, other.at.y - point->at.y}) <= 1e-6 * size_at(other.at, options.extent);
    });
    if (same == result.end()) {
      result.push_back(*point);
    } else if (point->residual < same->residual) {
      *same = *point;
    }
  }
  std::sort(result.begin(), result.end(), [](const FixedPoint& a, const FixedPoint& b) {
    return std::tuple(a.period, a.at.x, a.at.y) < std::tuple(b.period, b.at.x, b.at.y);
  });
  return result;
}

void detail::require_scan(const Rectangle& box, const FixedPointOptions& options) {
  require(options);
  if (!(box.width() > 0 && box.height() > 0)) throw UsageError("the box of a scan for fixed points is empty");
}

std::vector<FixedPoint> find_fixed_points(const PlanarMap& map, const Rectangle& box,
                                          const FixedPointOptions& options) {
  require_scan(box, options);
  const DisplacementGrid grid(map, box, options);
  std::vector<FixedPoint> result = scan(map, box, options, grid);
  if (result.empty()) {
    const auto [point, least] = grid.nearest();
    throw DataError(
        "no point of period " + std::to_string(options.period) + " in [" + format_number(box.min_x) + ", " +
        format_number(box.max_x) + "] x [" + format_number(box.min_y) + ", " + format_number(box.max_y) + "]: " +
        (std::isnan(least) ? "no point of the box has an image"
                           : "the displacement is least, " + format_number(least) + ", at " + format_point(point)));
  }
  return result;
}

}  // namespace lober
