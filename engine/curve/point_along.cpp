#include "engine/curve/point_along.hpp"

#include <cmath>

namespace lober {
namespace {

double along(double from, double to, DD t) {
  if (std::isfinite(to - from)) {
    const DD value = DD{from, 0} + t * two_diff(to, from);
    return value.hi;
  }
  // Both are large, so their quarters are exact.
  const DD value = DD{0.25 * from, 0} + t * two_diff(0.25 * to, 0.25 * from);
  return 4 * value.hi;
}

}  // namespace

Point point_along(const Segment& segment, DD t) {
  return {along(segment.a.x, segment.b.x, t), along(segment.a.y, segment.b.y, t)};
}

}  // namespace lober
