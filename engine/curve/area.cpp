#include <algorithm>
#include <vector>

#include "engine/curve/curve.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober {

double signed_area(CurveView curve) {
  constexpr std::size_t grain = 128 * leaf_size;
  const std::size_t size = curve.points.size();
  if (size == 0) return 0;
  const Point origin = curve.points[0];
  std::vector<DD> partial((size + grain - 1) / grain);
  for_each_block(size, grain, [&](std::size_t begin, std::size_t end) {
    LeafPrefixes prefixes;
    DD sum;
    std::size_t k = begin;
    for (; k + leaf_size <= end && k + leaf_size < size; k += leaf_size) {
      sum = shoelace_prefixes(&curve.points[k], origin, sum, nullptr, prefixes);
    }
    // The chord that closes the curve ends at the origin and adds nothing.
    for (; k < end && k + 1 < size; ++k) sum += shoelace(curve.points[k], curve.points[k + 1], origin);
    partial[begin / grain] = sum;
  });
  DD total;
  for (const DD& part : partial) total += part;
  return 0.5 * (total.hi + total.lo);
}

Orientation orientation(CurveView curve) {
  const double area = signed_area(curve);
  return area > 0 ? Orientation::counter_clockwise : area < 0 ? Orientation::clockwise : Orientation::degenerate;
}

}  // namespace lober
