// The points where a curve meets another one, in order along it (private to densify/).
#pragma once

#include <array>
#include <cstdint>

#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail {

struct Meeting {
  Position at;     ///< t = 1 for the last vertex of an open curve only
  Point point;     ///< the same bits on both curves
  bool at_vertex;  ///< whether `point` is a vertex of this curve
};

/// The meetings of two curves, either of which may be open or cross itself, in exact order along the first and along
/// the second. Vertices inside an arc that both share vertex by vertex are left out. Neither may have repeated
/// vertices. O(N + M + candidates), parallel.
[[nodiscard]] std::array<Buffer<Meeting>, 2> find_meetings(CurveView first, CurveView second);

}  // namespace lober::detail
