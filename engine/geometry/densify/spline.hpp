// The cubic spline through the vertices of a curve (private to densify/).
#pragma once

#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// Second derivatives, at each vertex, of the cubic spline over chord length: periodic for a closed curve, not-a-knot
/// at the ends of an open one (a parabola through three vertices, a line through two). No two neighbours may be equal.
///
/// The equations h_{k-1} M_{k-1} + 2 (h_{k-1} + h_k) M_k + h_k M_{k+1} = 6 (d_k - d_{k-1}), with d_k = (x_{k+1} - x_k)
/// / h_k, are solved in blocks that overlap: what is wrong `guard` rows outside a block, where M is taken to be zero,
/// reaches it shrunk by at least 2^-guard, because an off-diagonal pair sums to half the diagonal. So a closed curve
/// needs no special solver, and the blocks are independent. O(N), parallel.
[[nodiscard]] Buffer<Point> spline_second_derivatives(CurveView curve);

}  // namespace lober::detail
