#include <atomic>
#include <cmath>

#include "engine/base/finite.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/require.hpp"
#include "lober/curve/curve.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t max_vertices = std::size_t{1} << 31;

/// How many distinct vertices there are, counted up to three.
int distinct_vertices(std::span<const Point> points) {
  if (points.empty()) return 0;
  const Point first = points.front();
  const Point* second = nullptr;
  for (const Point& point : points) {
    if (point == first) continue;
    if (second == nullptr) {
      second = &point;
    } else if (point != *second) {
      return 3;
    }
  }
  return second == nullptr ? 1 : 2;
}

}  // namespace

std::size_t detail::first_not_finite(std::span<const Point> points) {
  constexpr std::size_t grain = std::size_t{1} << 16;
  std::atomic<std::size_t> first = points.size();
  for_each_block(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) continue;
      std::size_t seen = first.load();
      while (i < seen && !first.compare_exchange_weak(seen, i)) {
      }
      return;
    }
  });
  return first;
}

bool detail::bounds_something(std::span<const Point> polygon) {
  return distinct_vertices(polygon) >= 3;
}

void require_enough_vertices(CurveView curve, std::string_view name) {
  const auto fail = [&](const std::string& message) { throw DataError(std::string(name) + ": " + message); };
  if (curve.points.size() >= max_vertices) {
    fail("has " + std::to_string(curve.points.size()) + " vertices, the limit is 2147483647");
  }
  const int needed = curve.closed ? 3 : 2;
  if (const int found = distinct_vertices(curve.points); found < needed) {
    fail("has " + std::to_string(found) + (found == 1 ? " distinct vertex, " : " distinct vertices, ") +
         (curve.closed ? "a closed curve needs three" : "an open curve needs two"));
  }
}

void validate(CurveView curve, std::string_view name) {
  if (const std::size_t bad = first_not_finite(curve.points); bad != curve.points.size()) {
    throw DataError(std::string(name) + ": vertex " + std::to_string(bad) + " is not finite");
  }
  require_enough_vertices(curve, name);
}

void drop_closing_vertex(std::vector<Point>& points) {
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
}

}  // namespace lober
