// Fewer points where there are more than needed.

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/running_sums.hpp"
#include "engine/geometry/densify/distinct_curve.hpp"
#include "kernels/point.hpp"
#include "lober/curve/densify.hpp"

namespace lober {
using namespace detail;
namespace {

double distance_to_segment(Point p, Point a, Point b) {
  const Point e{b.x - a.x, b.y - a.y};
  const double square = e.x * e.x + e.y * e.y;
  const double along = square > 0 ? ((p.x - a.x) * e.x + (p.y - a.y) * e.y) / square : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.x + t * e.x, a.y + t * e.y});
}

// The first of the points for which `measure` is largest.
template <typename Measure>
std::uint32_t farthest(std::span<const Point> points, const Measure& measure) {
  std::vector<std::uint32_t> best((points.size() + pass_grain - 1) / pass_grain);
  for_each_block(points.size(), pass_grain, [&](std::size_t first, std::size_t last) {
    std::size_t here = first;
    double value = measure(points[first]);
    for (std::size_t k = first + 1; k < last; ++k) {
      if (const double next = measure(points[k]); next > value) {
        here = k;
        value = next;
      }
    }
    best[first / pass_grain] = static_cast<std::uint32_t>(here);
  });
  return *std::max_element(best.begin(), best.end(),
                           [&](std::uint32_t x, std::uint32_t y) { return measure(points[x]) < measure(points[y]); });
}

// A vertex that is still there, and how far at most what was removed between it and the next one lies from their
// segment.
struct Kept {
  Point point;
  double removed;
  bool stays;
};

// Vertices that every result keeps, so that a closed curve does not collapse.
Buffer<Kept> all_kept(CurveView curve) {
  const std::span<const Point> points = curve.points;
  Buffer<Kept> kept(points.size());
  for_each_block(points.size(), pass_grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) kept[k] = {points[k], 0, false};
  });
  kept.front().stays = true;
  if (!curve.closed) {
    kept.back().stays = true;
    return kept;
  }
  const Point origin = points[0];
  const std::uint32_t far = farthest(points, [&](Point p) { return distance(origin, p); });
  const Point direction{points[far].x - origin.x, points[far].y - origin.y};
  std::size_t side = farthest(
      points, [&](Point p) { return std::fabs((p.x - origin.x) * direction.y - (p.y - origin.y) * direction.x); });
  if (side == 0 || side == far) {  // all on a line
    const auto third =
        std::find_if(points.begin(), points.end(), [&](Point p) { return !(p == origin) && !(p == points[far]); });
    side = third != points.end() ? static_cast<std::size_t>(third - points.begin()) : 0;
  }
  kept[far].stays = kept[side].stays = true;
  return kept;
}

// Removes those removable vertices whose number has this parity, so that no two neighbours go together.
Buffer<Kept> simplified(const Buffer<Kept>& kept, std::size_t parity, const SimplifyOptions& options) {
  const std::size_t size = kept.size();
  // Removing vertex k leaves the segment before -> after with this bound; infinity when the vertex has to stay.
  const auto bound = [&](std::size_t k) {
    constexpr double stays = Criteria::off;
    const std::size_t next = k + 1 == size ? 0 : k + 1;
    if (k >= size || k % 2 != parity || k == 0 || kept[k].stays || (next == 0 && parity == 0)) return stays;
    const Point a = kept[k - 1].point, b = kept[next].point;
    const double removed = std::max(kept[k - 1].removed, kept[k].removed) + distance_to_segment(kept[k].point, a, b);
    return removed <= options.tolerance && distance(a, b) <= options.max_length ? removed : stays;
  };
  Buffer<double> bounds(size + 1);
  for_each_block(size + 1, pass_grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) bounds[k] = bound(k);
  });
  return gathered<Kept>(
      size, [&](std::size_t k) { return bounds[k] == Criteria::off; },
      [&](std::size_t k) {
        Kept vertex = kept[k];
        if (bounds[k + 1] < Criteria::off) vertex.removed = bounds[k + 1];
        return vertex;
      });
}

}  // namespace

DensifiedCurve simplify(CurveView curve, const SimplifyOptions& options) {
  if (!(options.tolerance >= 0) || options.tolerance == Criteria::off || !(options.max_length > 0)) {
    throw UsageError("simplify: the tolerance has to be zero or positive and finite, the maximum length positive");
  }
  const DistinctCurve given(curve);
  const SimplifyOptions scaled{given.to_view(options.tolerance), given.to_view(options.max_length)};
  DensifiedCurve result;
  Buffer<Kept> kept = all_kept(given.view());
  for (std::uint32_t round = 1, idle = 0; idle < 2; ++round) {
    const std::size_t before = kept.size();
    kept = simplified(kept, round % 2, scaled);
    idle = kept.size() == before ? idle + 1 : 0;
    if (idle == 0) ++result.rounds;
  }
  result.points = gathered<Point>(
      kept.size(), [](std::size_t) { return true; }, [&](std::size_t k) { return kept[k].point; });
  given.from_view(result.points);
  result.closed = curve.closed;
  return result;
}

}  // namespace lober
