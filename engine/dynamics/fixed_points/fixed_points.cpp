#include "lober/dynamics/fixed_points.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/fixed_points/displacement_grid.hpp"
#include "engine/dynamics/fixed_points/least_period.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/cancellation.hpp"
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

bool in_box(const Rectangle& box, Point z) {
  const double slack = 1e-9 * size_at({box.width(), box.height()}, extent_of(box));
  return box.min_x - slack <= z.x && z.x <= box.max_x + slack && box.min_y - slack <= z.y && z.y <= box.max_y + slack;
}

/// Newton's method goes on by the map from where it has ended half way; those that did not converge, or did so outside
/// the box, stay as they are.
std::vector<NewtonEnd> by_the_map_itself(const PlanarMap& map, std::vector<NewtonEnd> ends, const Rectangle& box,
                                         const FixedPointOptions& options) {
  std::vector<std::size_t> which;
  std::vector<Point> guesses;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (!ends[k].converged || !in_box(box, ends[k].at)) continue;
    which.push_back(k);
    guesses.push_back(ends[k].at);
  }
  const std::vector<NewtonEnd> final_ends = newton(map, guesses, options, 1e-3 * extent_of(box), nullptr, true);
  for (std::size_t i = 0; i < which.size(); ++i) ends[which[i]] = final_ends[i];
  return ends;
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
    for (int period = 1; period < options.period && is_finite(end.at); ++period) {
      const std::optional<FixedPointOptions> smaller = of_divisor(options, period);
      if (!smaller) continue;
      const NewtonEnd there = newton(map, end.at, *smaller, reach);
      if (there.converged) return describe(map, {&there.at, 1}, *smaller)[0];
    }
    throw DataError("no point of period " + std::to_string(options.period) + " found from " + format_point(guess) +
                    (std::isfinite(end.residual) ? ": Newton's method ended at " + format_point(end.at) + ", off by " +
                                                       format_number(end.residual)
                                                 : ": it has no image under the map"));
  }
  return describe(map, {&end.at, 1}, options)[0];
}

void detail::add_points(std::vector<FixedPoint>& points, std::span<const FixedPoint> more, double extent) {
  for (const FixedPoint& point : more) {
    throw_if_cancelled();
    const auto same = std::find_if(points.begin(), points.end(), [&](const FixedPoint& other) {
      return length(other.at - point.at) <= 1e-6 * size_at(other.at, extent);
    });
    if (same == points.end()) {
      points.push_back(point);
    } else if (std::tuple(point.period, point.residual) < std::tuple(same->period, same->residual)) {
      *same = point;
    }
  }
  std::sort(points.begin(), points.end(), [](const FixedPoint& a, const FixedPoint& b) {
    return std::tuple(a.period, a.at.x, a.at.y) < std::tuple(b.period, b.at.x, b.at.y);
  });
}

std::vector<FixedPoint> detail::scan_for_smaller_periods(const PlanarMap& map, const Rectangle& box,
                                                         const FixedPointOptions& options, const HalfWayMap* half_way,
                                                         const SearchAllowance* allowance) {
  std::vector<FixedPoint> points;
  for (int period = 1; period < options.period; ++period) {
    const std::optional<FixedPointOptions> smaller = of_divisor(options, period);
    if (!smaller || (allowance && !allowance->has(0))) continue;
    const DisplacementGrid grid(map, box, *smaller);
    add_points(points, scan(map, box, *smaller, grid, half_way, allowance), std::min(options.extent, extent_of(box)));
  }
  return points;
}

std::vector<FixedPoint> detail::scan(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& wanted,
                                     const DisplacementGrid& grid, const HalfWayMap* half_way,
                                     const SearchAllowance* allowance) {
  FixedPointOptions options = wanted;
  options.extent = std::min(wanted.extent, extent_of(box));
  std::vector<std::optional<FixedPoint>> found;
  // Degenerate points that are enough to see that they are not isolated.
  constexpr std::size_t max_degenerate = 2000;
  // Points outside the box are not wanted: iterations may leave it for a while, but not for the singularities around
  // it.
  const double reach = 2 * grid.cell(), aside = std::max(box.width(), reach), above = std::max(box.height(), reach);
  const Rectangle around{box.min_x - aside, box.min_y - above, box.max_x + aside, box.max_y + above};
  // `met`: the map whose displacements Newton's method brings to zero first.
  const auto follow = [&](const PlanarMap& met, const std::vector<Point>& in_rows) {
    const std::size_t known = found.size();
    found.resize(known + in_rows.size());
    // Whether there is work left is asked between rounds, so that it does not depend on threads.
    const std::size_t seeds_a_task = std::max<std::size_t>(16, map.batch() / 8), seeds_a_round = 2 * seeds_a_task;
    // Each round has seeds from all of the box: the work may end after any of them.
    const std::size_t rounds = (in_rows.size() + seeds_a_round - 1) / seeds_a_round;
    std::vector<Point> seeds;
    for (std::size_t first = 0; first < rounds; ++first) {
      for (std::size_t k = first; k < in_rows.size(); k += rounds) seeds.push_back(in_rows[k]);
    }
    std::size_t degenerate = 0;
    for (std::size_t round = 0;
         round < seeds.size() && (!allowance || allowance->has(0)) && degenerate < max_degenerate;
         round += seeds_a_round) {
      for_each_block(std::min(seeds_a_round, seeds.size() - round), seeds_a_task,
                     [&](std::size_t begin, std::size_t end) {
                       const auto some = std::span(seeds).subspan(round + begin, end - begin);
                       std::vector<NewtonEnd> ends = newton(met, some, options, reach, &around, true);
                       if (&met != &map) ends = by_the_map_itself(map, ends, box, options);
                       std::vector<std::size_t> which;
                       std::vector<Point> at;
                       for (std::size_t k = 0; k < ends.size(); ++k) {
                         if (!ends[k].converged || !in_box(box, ends[k].at)) continue;
                         which.push_back(known + round + begin + k);
                         at.push_back(ends[k].at);
                       }
                       const std::vector<FixedPoint> points = describe(map, at, options);
                       for (std::size_t k = 0; k < which.size(); ++k) {
                         if (in_box(box, points[k].at)) found[which[k]] = points[k];
                       }
                     });
      throw_if_cancelled();
      for (std::size_t k = round; k < std::min(round + seeds_a_round, seeds.size()); ++k) {
        const std::optional<FixedPoint>& point = found[known + k];
        if (point && index_of(*point, options.period) == 0) ++degenerate;
      }
    }
  };
  // Where all points of the grid can be followed both ways, seeds of the map itself add none but far more stretched
  // ones.
  bool followed = false;
  if (half_way != nullptr) {
    const DisplacementGrid halves(*half_way, box, options);
    follow(*half_way, halves.seeds());
    followed = halves.all_have_images();
  }
  if (!followed) follow(map, grid.seeds());
  std::vector<FixedPoint> all, result;
  for (const std::optional<FixedPoint>& point : found) {
    if (point) all.push_back(*point);
  }
  add_points(result, all, options.extent);
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
  const std::unique_ptr<HalfWayMap> half_way = half_way_map(map);
  std::vector<FixedPoint> result = scan(map, box, options, grid, half_way.get());
  add_points(result, scan_for_smaller_periods(map, box, options, half_way.get()),
             std::min(options.extent, extent_of(box)));
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
