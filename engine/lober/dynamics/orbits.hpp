// Orbits of many points under a planar map: Poincare sections.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "lober/base/buffer.hpp"
#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober {

/// Points spread evenly over a rectangle; the first ones are the same for any count: an additive recurrence with the
/// powers of 1 / 1.3247..., the real root of x^3 = x + 1. O(count).
[[nodiscard]] LOBER_API Buffer<Point> spread_points(const Rectangle& rectangle, std::size_t count);

/// The point shifted by a whole number of times the lattice, so that it lies less than one shift past `origin` along
/// it; unchanged where the lattice is (0, 0). To rounding.
[[nodiscard]] LOBER_API Point folded(Point point, Point lattice, Point origin);
/// The point shifted by two lattices into the parallelogram that they span from `origin` on. A lattice that is (0, 0)
/// does not count; neither does the second one where it is a multiple of the first.
[[nodiscard]] LOBER_API Point folded(Point point, Point lattice, Point second_lattice, Point origin);

/// Options of follow_orbits.
struct OrbitOptions {
  std::size_t iterates = 0;  ///< number of iterates of each orbit
  /// Shift of the plane after which the map repeats itself: points are folded after every step, to the part past
  /// `origin`; (0, 0): they are not folded.
  Point lattice{}, origin{};
  Point second_lattice{};  ///< another shift, for a map that repeats itself in two directions
};

/// Follows every point and hands over the orbits, in order, some at a time: the number of the first of them, and for
/// each iterates + 1 points, the point itself first. From where an orbit cannot be followed, its points are NaN. `take`
/// returns false to cancel. About 64 MiB of memory, more for orbits of more than 200 000 points. Throws Cancelled.
/// Parallel; the same bits for any number of threads.
LOBER_API void follow_orbits(const PlanarMap& map, std::span<const Point> starts, const OrbitOptions& options,
                             const std::function<bool(std::size_t first, std::span<const Point> points)>& take);

}  // namespace lober
