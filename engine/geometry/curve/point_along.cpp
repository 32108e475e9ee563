#include "engine/geometry/curve/point_along.hpp"

#include <cmath>

namespace lober::detail {
namespace {

double coordinate_along(double from, double to, DD t) {
  constexpr double large = 0x1p900, down = 0x1p-200;
  if (std::fabs(from) < large && std::fabs(to) < large) {
    const DD value = DD{from, 0} + t * two_diff(to, from);
    return value.hi;
  }
  // Products of double-doubles need some room below the largest double.
  const DD value = DD{down * from, 0} + t * two_diff(down * to, down * from);
  return value.hi / down;
}

}  // namespace

Point point_along(const Segment& segment, DD t) {
  return {coordinate_along(segment.a.x, segment.b.x, t), coordinate_along(segment.a.y, segment.b.y, t)};
}

}  // namespace lober::detail
