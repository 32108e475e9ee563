#include "lober/dynamics/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t orbits_together = 16;  // orbits that are followed together: the lanes of the integrator, twice
constexpr std::size_t block_points = std::size_t{1} << 22;
constexpr double short_block = 0.1;  // seconds

}  // namespace

Buffer<Point> spread_points(const Rectangle& rectangle, std::size_t count) {
  constexpr double root = 1.32471795724474602596;
  constexpr double step_x = 1 / root, step_y = 1 / (root * root);
  const auto between = [](double low, double high, double t) { return low * (1 - t) + high * t; };
  Buffer<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = 0.5 + static_cast<double>(k) * step_x, y = 0.5 + static_cast<double>(k) * step_y;
    points[k] = {between(rectangle.min_x, rectangle.max_x, x - std::floor(x)),
                 between(rectangle.min_y, rectangle.max_y, y - std::floor(y))};
  }
  return points;
}

Point folded(Point point, Point lattice, Point origin) {
  const double square = lattice.x * lattice.x + lattice.y * lattice.y;
  if (!(square > 0)) return point;
  const double along = ((point.x - origin.x) * lattice.x + (point.y - origin.y) * lattice.y) / square;
  const double turns = std::floor(along);
  return {point.x - turns * lattice.x, point.y - turns * lattice.y};
}

Point folded(Point point, Point lattice, Point second_lattice, Point origin) {
  const double span = lattice.x * second_lattice.y - lattice.y * second_lattice.x;
  if (span == 0) return folded(point, lattice == Point{} ? second_lattice : lattice, origin);
  const double x = point.x - origin.x, y = point.y - origin.y;
  const double turns = std::floor((x * second_lattice.y - y * second_lattice.x) / span);
  const double second_turns = std::floor((lattice.x * y - lattice.y * x) / span);
  return {point.x - turns * lattice.x - second_turns * second_lattice.x,
          point.y - turns * lattice.y - second_turns * second_lattice.y};
}

void follow_orbits(const PlanarMap& map, std::span<const Point> starts, const OrbitOptions& options,
                   const std::function<bool(std::size_t first, std::span<const Point> points)>& take) {
  const std::size_t each = options.iterates + 1, together = std::max(orbits_together, map.batch());
  // Blocks are as long as the caller wants to wait for the next one, and as memory allows. Results do not depend on
  // that.
  const std::size_t max_groups = std::max<std::size_t>(block_points / each / together, 1);
  std::size_t groups = std::min(max_groups, 2 * static_cast<std::size_t>(std::max(concurrency(), 1)));
  const auto fold = [&](Point point) { return folded(point, options.lattice, options.second_lattice, options.origin); };
  Buffer<Point> points;
  for (std::size_t first = 0, count = 0; first < starts.size(); first += count) {
    const Stopwatch watch;
    count = std::min(groups * together, starts.size() - first);
    points.resize(count * each);
    for_each_block(count, together, [&](std::size_t begin, std::size_t end) {
      const std::size_t size = end - begin;
      std::vector<Point> state(size);
      for (std::size_t k = 0; k < size; ++k) state[k] = fold(starts[first + begin + k]);
      for (std::size_t n = 0; n < each; ++n) {
        if (n > 0) map.iterate(state, 1);
        for (std::size_t k = 0; k < size; ++k) {
          if (n > 0) state[k] = fold(state[k]);
          points[(begin + k) * each + n] = state[k];
        }
        if (n % 1024 == 1023) throw_if_cancelled();
      }
    });
    if (watch.seconds() < short_block) groups = std::min(2 * groups, max_groups);
    if (!take(first, points)) throw Cancelled();
  }
}

}  // namespace lober
