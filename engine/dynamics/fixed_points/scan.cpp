// One scan: Newton's method from the seeds of a grid, and the orbits of what it finds.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/fixed_points/displacement_grid.hpp"
#include "engine/dynamics/fixed_points/least_period.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"
#include "engine/dynamics/fixed_points/uncertainty.hpp"
#include "engine/dynamics/fixed_points/valleys.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/cancellation.hpp"

namespace lober {
using namespace detail;
namespace {

// Places in a list of points by their abscissas.
using ByAbscissa = std::multimap<double, std::size_t>;

bool in_box(const Rectangle& box, Point z) {
  const double slack = 1e-9 * size_at({box.width(), box.height()}, extent_of(box));
  return box.min_x - slack <= z.x && z.x <= box.max_x + slack && box.min_y - slack <= z.y && z.y <= box.max_y + slack;
}

/// The numbers of the ends that have converged in the box, and their places.
struct Arrived {
  std::vector<std::size_t> which;
  std::vector<Point> at;
};
Arrived arrived_in(const Rectangle& box, std::span<const NewtonEnd> ends) {
  Arrived arrived;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (!ends[k].converged || !in_box(box, ends[k].at)) continue;
    arrived.which.push_back(k);
    arrived.at.push_back(ends[k].at);
  }
  return arrived;
}

/// Newton's method goes on by the map from where it has ended half way; those that did not converge, or did so outside
/// the box, stay as they are.
std::vector<NewtonEnd> by_the_map_itself(const PlanarMap& map, std::vector<NewtonEnd> ends, const Rectangle& box,
                                         const FixedPointOptions& options) {
  const auto [which, guesses] = arrived_in(box, ends);
  const std::vector<NewtonEnd> final_ends = newton(map, guesses, options, 1e-3 * extent_of(box), nullptr, true);
  for (std::size_t i = 0; i < which.size(); ++i) ends[which[i]] = final_ends[i];
  return ends;
}

/// Newton's method from some guesses, at most as many as one call should have: the points in the box, each at the place
/// of its guess. `met`: the map whose displacements it brings to zero first.
std::vector<std::optional<FixedPoint>> follow(const PlanarMap& map, const PlanarMap& met,
                                              std::span<const Point> guesses, double reach, const Rectangle& around,
                                              const Rectangle& box, const FixedPointOptions& options) {
  std::vector<NewtonEnd> ends = newton(met, guesses, options, reach, &around, true);
  if (&met != &map) ends = by_the_map_itself(map, ends, box, options);
  const auto [which, at] = arrived_in(box, ends);
  const std::vector<FixedPoint> points = describe(map, at, options);
  std::vector<std::optional<FixedPoint>> found(guesses.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    if (in_box(box, points[k].at)) found[which[k]] = points[k];
  }
  return found;
}

/// The places in the box where a point and its images are, moved by multiples of the lattice.
std::vector<Point> orbit_in_box(const PlanarMap& map, const FixedPoint& point, const Rectangle& box, Point lattice) {
  constexpr double max_copies = 64;
  const double squares = dot(lattice, lattice);
  const Point middle{0.5 * (box.min_x + box.max_x), 0.5 * (box.min_y + box.max_y)};
  const double across = squares > 0 ? std::ceil(std::hypot(box.width(), box.height()) / std::sqrt(squares)) : 0;
  const int copies = static_cast<int>(std::min(max_copies, across));
  std::vector<Point> places;
  Point z = point.at;
  const int images = map.takes_all_iterates() ? point.period : 1;
  for (int k = 0; k < images && is_finite(z); ++k) {
    const double nearest = squares > 0 ? std::round(dot(middle - z, lattice) / squares) : 0;
    for (int n = -copies; n <= copies; ++n) {
      const Point place{z.x + (nearest + n) * lattice.x, z.y + (nearest + n) * lattice.y};
      if (in_box(box, place)) places.push_back(place);
    }
    map.iterate({&z, 1}, 1);
  }
  return places;
}

}  // namespace

void detail::add_points(std::vector<FixedPoint>& points, std::span<const FixedPoint> more, double extent) {
  ByAbscissa places;
  double widest = 0;
  const auto uncertain_by = [&](const FixedPoint& point) {
    const double size = size_at(point.at, extent);
    return std::max(same_place * size, uncertainty(point, size));
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    places.emplace(points[k].at.x, k);
    widest = std::max(widest, uncertain_by(points[k]));
  }
  for (const FixedPoint& point : more) {
    throw_if_cancelled();
    const double own = uncertain_by(point), reach = 2 * std::max(own, widest);
    std::size_t same = points.size();
    for (auto k = places.lower_bound(point.at.x - reach); k != places.end() && k->first <= point.at.x + reach; ++k) {
      if (k->second < same && are_same(points[k->second], point, extent)) same = k->second;
    }
    if (same == points.size()) {
      points.push_back(point);
      places.emplace(point.at.x, same);
      widest = std::max(widest, own);
    } else if (std::tuple(point.period, point.residual) < std::tuple(points[same].period, points[same].residual)) {
      points[same] = point;
    }
  }
  std::sort(points.begin(), points.end(), [](const FixedPoint& a, const FixedPoint& b) {
    return std::tuple(a.period, a.at.x, a.at.y) < std::tuple(b.period, b.at.x, b.at.y);
  });
}

std::vector<FixedPoint> detail::scan_for_smaller_periods(const PlanarMap& map, const Rectangle& box,
                                                         const FixedPointOptions& options, const HalfWayMap& half_way,
                                                         const SearchAllowance* allowance) {
  std::vector<FixedPoint> points;
  for (const FixedPointOptions& smaller : of_divisors(options)) {
    if (smaller.period == options.period || (allowance && !allowance->has(0))) break;
    const ScanGrids grids(map, half_way, box, smaller);
    add_points(points, scan(map, box, smaller, grids, half_way, allowance), options.extent);
  }
  return points;
}

std::vector<FixedPoint> detail::scan(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options,
                                     const ScanGrids& grids, const HalfWayMap& half_way,
                                     const SearchAllowance* allowance) {
  // Degenerate points that are enough to see that they are not isolated.
  constexpr std::size_t max_degenerate = 2000;
  // Points outside the box are not wanted: iterations may leave it for a while, but not for the singularities around
  // it.
  const double reach = 2 * grids.cell(), aside = std::max(box.width(), reach), above = std::max(box.height(), reach);
  const Rectangle around{box.min_x - aside, box.min_y - above, box.max_x + aside, box.max_y + above};
  std::vector<FixedPoint> result;
  const auto follow_all = [&](const PlanarMap& met, const std::vector<Point>& in_rows) {
    // Whether there is work left is asked between rounds, so that it does not depend on threads.
    const std::size_t seeds_a_task = std::max<std::size_t>(16, map.batch() / 8), seeds_a_round = 2 * seeds_a_task;
    // Each round has seeds from all of the box: the work may end after any of them.
    const std::size_t rounds = (in_rows.size() + seeds_a_round - 1) / seeds_a_round;
    std::vector<Point> seeds;
    for (std::size_t first = 0; first < rounds; ++first) {
      for (std::size_t k = first; k < in_rows.size(); k += rounds) seeds.push_back(in_rows[k]);
    }
    std::vector<FixedPoint> ended;
    std::size_t degenerate = 0;
    for (std::size_t round = 0;
         round < seeds.size() && (!allowance || allowance->has(0)) && degenerate < max_degenerate;
         round += seeds_a_round) {
      std::vector<std::optional<FixedPoint>> ends(std::min(seeds_a_round, seeds.size() - round));
      for_each_block(ends.size(), seeds_a_task, [&](std::size_t begin, std::size_t end) {
        const auto some = std::span(seeds).subspan(round + begin, end - begin);
        std::ranges::move(follow(map, met, some, reach, around, box, options),
                          ends.begin() + static_cast<std::ptrdiff_t>(begin));
      });
      throw_if_cancelled();
      for (const std::optional<FixedPoint>& point : ends) {
        if (!point) continue;
        ended.push_back(*point);
        if (index_of(*point, options.period) == 0) ++degenerate;
      }
    }
    add_points(result, ended, options.extent);
  };
  if (grids.halves() != nullptr) follow_all(half_way, grids.halves()->seeds());
  if (grids.whole() != nullptr) follow_all(map, grids.whole()->seeds());
  // For the work along a valley of a flow a finer grid shows more.
  if (by_formula(map)) follow_all(map, guesses_in_valleys(map, result, box, options));
  // The images of a point are such points too, and neither grid need see them.
  ByAbscissa places;
  for (std::size_t k = 0; k < result.size(); ++k) places.emplace(result[k].at.x, k);
  std::vector<Point> images;
  for (const FixedPoint& point : result) {
    for (const Point place : orbit_in_box(map, point, box, options.lattice)) {
      const double near = same_place * size_at(place, options.extent);
      const auto is_here = [&](const auto& entry) { return length(result[entry.second].at - place) <= near; };
      if (std::none_of(places.lower_bound(place.x - near), places.upper_bound(place.x + near), is_here)) {
        images.push_back(place);
      }
    }
  }
  follow_all(grids.halves() != nullptr ? static_cast<const PlanarMap&>(half_way) : map, images);
  return result;
}

}  // namespace lober
