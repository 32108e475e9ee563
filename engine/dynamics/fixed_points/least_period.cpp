#include "engine/dynamics/fixed_points/least_period.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/dynamics/fixed_points/classify.hpp"
#include "engine/dynamics/fixed_points/degenerate.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/uncertainty.hpp"
#include "engine/dynamics/maps/plane.hpp"

namespace lober::detail {
namespace {

/// As points of this very period.
std::vector<FixedPoint> as_of_period(const PlanarMap& map, std::span<const Point> at,
                                     const FixedPointOptions& options) {
  std::vector<Point> images(at.begin(), at.end());
  std::vector<Matrix2> derivatives(at.size());
  map.iterate_with_derivatives(images, options.period, derivatives);
  std::vector<FixedPoint> result(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    result[k].at = at[k];
    result[k].period = options.period;
    result[k].derivative = derivatives[k];
    result[k].residual = length(gap_between(at[k], images[k], options));
  }
  return result;
}

/// Marks those whose determinant of D - 1 may be 0: within their uncertainty it varies by as much as half of itself, or
/// it is rounding.
void mark_degenerate(const PlanarMap& map, std::vector<FixedPoint>& points, const FixedPointOptions& options) {
  constexpr double suspicious = 1e-5, rounding = 1e-14;
  for (const FixedPointOptions& each : of_divisors(options)) {
    std::vector<std::size_t> which;
    std::vector<Point> around;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Matrix2 a = less_1(points[k].derivative);
      if (points[k].period != each.period || std::abs(determinant(a)) > suspicious * (1 + norm_of(a))) continue;
      which.push_back(k);
      const Point z = points[k].at, along = null_direction(a);
      const double reach = uncertainty(points[k], size_at(z, options.extent));
      around.insert(around.end(),
                    {{z.x - reach * along.x, z.y - reach * along.y}, {z.x + reach * along.x, z.y + reach * along.y}});
    }
    if (which.empty()) continue;
    std::vector<Matrix2> derivatives(around.size());
    map.iterate_with_derivatives(around, each.period, derivatives);
    std::vector<std::size_t> uncertain;
    std::vector<Point> at;
    for (std::size_t i = 0; i < which.size(); ++i) {
      const FixedPoint& point = points[which[i]];
      const Matrix2 a = less_1(point.derivative);
      const double here = determinant(a), norm = 1 + norm_of(a);
      const auto is_near = [&](const Matrix2& d) {
        return std::abs(determinant(less_1(d)) - here) <= 0.5 * std::abs(here);
      };
      const bool certain =
          std::abs(here) > rounding * norm * norm && is_near(derivatives[2 * i]) && is_near(derivatives[2 * i + 1]);
      if (certain) continue;
      uncertain.push_back(which[i]);
      at.push_back(point.at);
    }
    if (uncertain.empty()) continue;
    sharpen_degenerate(map, at, each);
    const std::vector<FixedPoint> sharp = as_of_period(map, at, each);
    for (std::size_t i = 0; i < uncertain.size(); ++i) {
      points[uncertain[i]] = sharp[i];
      classify_degenerate(points[uncertain[i]]);
    }
  }
}

/// The point of a smaller period that this one is to within its uncertainty: also that of its own period, which is
/// found more exactly than by all of options.period.
std::optional<FixedPoint> of_smaller_period(const PlanarMap& map, const FixedPoint& point,
                                            const FixedPointOptions& options) {
  constexpr double certain = 1e-8, exact = 1e-14;
  const double size = size_at(point.at, options.extent);
  const double radius = std::max(certain * size, uncertainty(point, size));
  const bool all_of_it = point.period == options.period;
  if (radius <= certain * size && (all_of_it || point.residual <= exact * size)) return std::nullopt;
  const Point corner{radius, radius};
  const Rectangle near = Rectangle::of(point.at - corner, point.at + corner);
  for (const FixedPointOptions& smaller : of_divisors(options)) {
    if (point.period % smaller.period != 0 || smaller.period == options.period) continue;
    const NewtonEnd end = newton(map, {&point.at, 1}, smaller, radius, &near)[0];
    if (end.converged) return as_of_period(map, {&end.at, 1}, smaller)[0];
  }
  return std::nullopt;
}

}  // namespace

std::vector<FixedPointOptions> of_divisors(const FixedPointOptions& options) {
  std::vector<FixedPointOptions> result;
  for (int period = 1; period <= options.period; ++period) {
    const std::int64_t turns = static_cast<std::int64_t>(options.turns) * period;
    if (options.period % period != 0 || turns % options.period != 0) continue;
    result.push_back(options);
    result.back().period = period;
    result.back().turns = static_cast<int>(turns / options.period);
  }
  return result;
}

std::vector<FixedPoint> describe(const PlanarMap& map, std::span<const Point> at, const FixedPointOptions& options) {
  constexpr double same = 1e-8;
  std::vector<FixedPoint> result(at.size());
  std::vector<std::size_t> open(at.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  // One call for each divisor of the period: calls may cost much.
  for (const FixedPointOptions& smaller : of_divisors(options)) {
    if (open.empty()) break;
    std::vector<Point> from;
    from.reserve(open.size());
    for (const std::size_t k : open) from.push_back(at[k]);
    const std::vector<FixedPoint> points = as_of_period(map, from, smaller);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (smaller.period < options.period && !(points[i].residual <= same * size_at(from[i], options.extent))) {
        left.push_back(open[i]);
      } else {
        result[open[i]] = points[i];
      }
    }
    open = std::move(left);
  }
  for (FixedPoint& point : result) {
    if (const std::optional<FixedPoint> smaller = of_smaller_period(map, point, options)) point = *smaller;
    classify(point);
  }
  mark_degenerate(map, result, options);
  return result;
}

}  // namespace lober::detail
