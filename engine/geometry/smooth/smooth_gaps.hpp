// Areas between two smooth open curves, up to each crossing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "kernels/double_double.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// The difference between the smooth curves through the points and the polygons at one crossing.
struct SmoothGap {
  DD twice;                ///< to be added to S_1 - S_2 up to the crossing (engine/lober/tangle/tangle.hpp)
  double error1 = 0;       ///< twice the error of that, summed along C1 and C2 from their beginnings: an arc between
  double error2 = 0;       ///< two crossings has the difference
  double uncertainty = 0;  ///< twice the area that may hide at the crossing itself
  Point at;                ///< where the smooth curves cross
  double position1 = 0;    ///< the same along C1 and along C2: number of a segment and parameter on it
  double position2 = 0;
  bool moved = false;  ///< false where they do not cross near by in the same order: then the polygons' crossing
};

struct SmoothGaps {
  std::vector<SmoothGap> at;
  std::uint64_t fallback_segments = 0;   ///< segments of both curves that stay straight
  std::uint64_t fallback_crossings = 0;  ///< that were not moved
};

/// The gaps at the given nodes, which ascend, by the method of smooth_areas (engine/lober/overlay/smooth.hpp), with the
/// sums of both curves, or of translates of them. Coordinates must be scaled (curve/scaled.hpp). O(nodes log nodes),
/// parallel; the same bits for any number of threads.
[[nodiscard]] SmoothGaps smooth_gaps(const SmoothCurve& c1, const SmoothCurve& c2, const ChordAreaTable& sums1,
                                     const ChordAreaTable& sums2, const NodeGraph& graph,
                                     std::span<const std::uint32_t> nodes);

}  // namespace lober::detail
