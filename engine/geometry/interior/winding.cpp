// Winding numbers, and labels that follow from them.

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/index/ray_crossings.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t windings_a_task = 256;  // queries a task

}  // namespace

Winding winding(const IndexedCurve& curve, Point point) {
  require_closed(curve.view(), "the curve", "winding number");
  const RayCrossings found = ray_crossings(curve.tree(), point);
  return {found.on ? 0 : found.number, found.on};
}

std::vector<Winding> windings(const IndexedCurve& curve, std::span<const Point> points) {
  std::vector<Winding> result(points.size());
  for_each_block(points.size(), windings_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) result[k] = winding(curve, points[k]);
  });
  return result;
}

Side locate(const IndexedCurve& curve, Point point) {
  const Winding here = winding(curve, point);
  return here.on ? Side::on : here.number != 0 ? Side::inside : Side::outside;
}

Buffer<Side> label_points(const IndexedCurve& curve, std::span<const Point> points) {
  Buffer<Side> labels(points.size());
  for_each_block(points.size(), windings_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) labels[k] = locate(curve, points[k]);
  });
  return labels;
}

}  // namespace lober
