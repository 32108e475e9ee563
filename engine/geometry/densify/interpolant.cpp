#include "engine/geometry/densify/interpolant.hpp"

#include "engine/base/parallel/running_sums.hpp"
#include "engine/geometry/densify/spline.hpp"

namespace lober {
using namespace detail;
namespace {

// The ends of an open curve have the curvature of the vertex next to them: the first and last pieces are parts of
// parabolas.
Buffer<double> curvatures(CurveView curve) {
  const std::span<const Point> points = curve.points;
  const std::size_t size = points.size();
  Buffer<double> result(size);
  for_each_block(size, pass_grain, [&](std::size_t begin, std::size_t end) {
    const std::size_t inner_begin = begin == 0 ? 1 : begin, inner_end = end == size ? size - 1 : end;
    for (std::size_t k = inner_begin; k < inner_end; ++k)
      result[k] = curvature(points[k - 1], points[k], points[k + 1]);
  });
  if (curve.closed) {
    result[0] = curvature(points[size - 1], points[0], points[1]);
    result[size - 1] = curvature(points[size - 2], points[size - 1], points[0]);
  } else {
    result[0] = size > 2 ? result[1] : 0;
    result[size - 1] = size > 2 ? result[size - 2] : 0;
  }
  return result;
}

}  // namespace

std::string_view name(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::dritschel:
      return "dritschel";
    case Interpolation::spline:
      return "spline";
    case Interpolation::linear:
      break;
  }
  return "linear";
}

Interpolant::Interpolant(CurveView curve, Interpolation kind) : curve_(curve), kind_(kind) {
  if (kind == Interpolation::dritschel) curvature_ = curvatures(curve);
  if (kind == Interpolation::spline) second_ = spline_second_derivatives(curve);
}

}  // namespace lober
