#include "engine/dynamics/fixed_points/valleys.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/uncertainty.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/cancellation.hpp"

namespace lober::detail {
namespace {

// The quotient of the singular values of D - 1, nearly.
double narrowness(const Matrix2& a) {
  const double norm = norm_of(a);
  return std::abs(determinant(a)) / (norm * norm);
}

Point times(double factor, Point p) {
  return {factor * p.x, factor * p.y};
}

// A place on the floor of a valley.
struct Floor {
  Point at;
  Point along;    // unit vector
  Point free;     // the unit vector that D - 1 does not reach
  double height;  // the displacement in that direction
};

// The floor across from z, no farther than `reach`, with the directions that it had before; none where the valley ends.
std::optional<Floor> floor_near(const PlanarMap& map, Point z, const Floor* before, double reach,
                                const FixedPointOptions& options) {
  constexpr int max_rounds = 8;
  constexpr double widest = 0.03, flat = 1e-3;
  const Point from = z;
  for (int round = 0; round < max_rounds && length(z - from) <= reach; ++round) {
    const auto [gap, derivative] = displacement_at(map, z, options);
    const Matrix2 a = less_1(derivative);
    if (!is_finite(gap) || !(narrowness(a) < widest)) return std::nullopt;
    const Point first{a.xx, a.yx}, second{a.xy, a.yy};
    const Point column = length(first) > length(second) ? first : second;
    const Point reached = times(1 / length(column), column), along = null_direction(a), across{-along.y, along.x};
    Floor floor{z, along, {-reached.y, reached.x}, 0};
    if (before != nullptr && dot(floor.along, before->along) < 0) floor.along = times(-1, floor.along);
    if (before != nullptr && dot(floor.free, before->free) < 0) floor.free = times(-1, floor.free);
    floor.height = dot(gap, floor.free);
    const double off = dot(gap, reached);
    const double noise = noise_of(map) * size_at(z, options.extent);
    if (std::abs(off) <= std::max(noise, flat * std::abs(floor.height))) return floor;
    const Point moved{a.xx * across.x + a.xy * across.y, a.yx * across.x + a.yy * across.y};
    z = z - times(off / dot(moved, reached), across);
  }
  return std::nullopt;
}

// Where the height is zero between two places of which it has opposite signs, by the Illinois method.
Point zero_between(const PlanarMap& map, const Floor& one, const Floor& other, const FixedPointOptions& options) {
  constexpr int max_rounds = 40;
  constexpr double near = 1e-9;
  const Point whole = other.at - one.at;
  const double reach = length(whole), enough = near * size_at(one.at, options.extent);
  double low = 0, high = 1, at_low = one.height, at_high = other.height;
  Point zero = one.at + times(0.5, whole);
  for (int round = 0; round < max_rounds && (high - low) * reach > enough; ++round) {
    const double t = (low * at_high - high * at_low) / (at_high - at_low);
    const std::optional<Floor> between = floor_near(map, one.at + times(t, whole), &one, reach, options);
    if (!between) break;
    zero = between->at;
    if (between->height == 0) break;
    if ((between->height > 0) == (at_high > 0)) {
      high = t;
      at_high = between->height;
      at_low /= 2;
    } else {
      low = t;
      at_low = between->height;
      at_high /= 2;
    }
  }
  return zero;
}

bool is_in_valley(const FixedPoint& point) {
  constexpr double narrow = 1e-6;
  const double width = narrowness(less_1(point.derivative));
  return width > 0 && width < narrow;
}

std::vector<Point> guesses_along(const PlanarMap& map, const FixedPoint& point, const Rectangle& box,
                                 const FixedPointOptions& options) {
  constexpr int max_steps = 8192, steps_a_period = 32;
  constexpr double least_turn = 0.98;  // cosine of the angle between two steps
  const double extent = extent_of(box), longest = extent / (steps_a_period * options.period), shortest = 1e-3 * longest;
  const Rectangle around{box.min_x - longest, box.min_y - longest, box.max_x + longest, box.max_y + longest};
  std::vector<Point> guesses;
  const std::optional<Floor> start = floor_near(map, point.at, nullptr, longest, options);
  if (!start) return guesses;
  for (const double way : {1.0, -1.0}) {
    Floor here = *start;
    here.along = times(way, here.along);
    double step = longest / 4;
    for (int number = 0; number < max_steps && around.contains(here.at); ++number) {
      throw_if_cancelled();
      const std::optional<Floor> next = floor_near(map, here.at + times(step, here.along), &here, step / 4, options);
      if (!next || dot(next->along, here.along) < least_turn) {
        step /= 2;
        if (step < shortest) break;
        continue;
      }
      // The point itself has a height that is rounding.
      if (number > 0 && (next->height > 0) != (here.height > 0)) {
        guesses.push_back(zero_between(map, here, *next, options));
      }
      here = *next;
      if (number > 8 && length(here.at - start->at) < step) return guesses;
      step = std::min(1.5 * step, longest);
    }
  }
  return guesses;
}

}  // namespace

std::vector<Point> guesses_in_valleys(const PlanarMap& map, std::span<const FixedPoint> points, const Rectangle& box,
                                      const FixedPointOptions& options) {
  constexpr int max_valleys = 16;
  std::vector<Point> guesses;
  int valleys = 0;
  for (const FixedPoint& point : points) {
    if (point.period != options.period || !is_in_valley(point)) continue;
    const double size = size_at(point.at, options.extent), near = same_place * size + uncertainty(point, size);
    const auto is_here = [&](Point z) { return length(z - point.at) <= near; };
    if (std::any_of(guesses.begin(), guesses.end(), is_here)) continue;
    if (valleys++ == max_valleys) break;
    const std::vector<Point> more = guesses_along(map, point, box, options);
    guesses.insert(guesses.end(), more.begin(), more.end());
  }
  return guesses;
}

}  // namespace lober::detail
