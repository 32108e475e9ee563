// The scaled and indexed curves that a tangle keeps (private to tangle/).
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/index/index.hpp"
#include "engine/geometry/smooth/smooth_gaps.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::detail {

/// D at a pip.
[[nodiscard]] inline DD gap_of(const Pip& pip) {
  return {pip.gap, pip.gap_low};
}

/// Both curves indexed, at a scale where products stay in range (curve/scaled.hpp).
struct TangleCurves {
  int exponent = 0;  // coordinates were multiplied by 2^exponent
  std::vector<Point> scaled_u, scaled_s;
  std::optional<IndexedCurve> index_u, index_s;  // indexes of the caller's curves, or of the scaled ones
  bool smooth = false;
  std::shared_ptr<const ChordAreaTable> chords_u, chords_s;  // if smooth

  [[nodiscard]] const IndexedCurve& u() const { return *index_u; }
  [[nodiscard]] const IndexedCurve& s() const { return *index_s; }

  [[nodiscard]] SmoothGaps smooth_gaps_at(const NodeGraph& graph, std::span<const std::uint32_t> nodes) const {
    return smooth_gaps(SmoothCurve(u().view()), SmoothCurve(s().view()), *chords_u, *chords_s, graph, nodes);
  }

  [[nodiscard]] double area(DD twice) const { return scaled_area(twice.hi + twice.lo, -1 - 2 * exponent); }
  [[nodiscard]] Point origin() const { return u().view().points[0]; }
};

}  // namespace lober::detail
