#include <cmath>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "kernels/box.hpp"
#include "kernels/shoelace.hpp"
#include "lober/curve/curve.hpp"

namespace lober {
using namespace detail;

namespace {

double twice_signed_area(std::span<const Point> points) {
  constexpr std::size_t grain = 128 * leaf_size;
  const std::size_t size = points.size();
  if (size == 0) return 0;
  const Point origin = points[0];
  std::vector<DD> partial((size + grain - 1) / grain);
  for_each_block(size, grain, [&](std::size_t begin, std::size_t end) {
    LeafPrefixes prefixes;
    DD sum;
    std::size_t k = begin;
    for (; k + leaf_size <= end && k + leaf_size < size; k += leaf_size) {
      sum = shoelace_prefixes(&points[k], origin, sum, nullptr, prefixes);
    }
    // The chord that closes the curve ends at the origin and adds nothing.
    for (; k < end && k + 1 < size; ++k) sum += shoelace(points[k], points[k + 1], origin);
    partial[begin / grain] = sum;
  });
  DD total;
  for (const DD& part : partial) total += part;
  return total.hi + total.lo;
}

}  // namespace

double signed_area(CurveView curve) {
  const double twice = twice_signed_area(curve.points);
  if (std::isfinite(twice)) return 0.5 * twice;
  const int exponent = scaling_exponent(box_of(curve.points));
  return scaled_area(twice_signed_area(scaled(curve, exponent)), -1 - 2 * exponent);
}

}  // namespace lober
