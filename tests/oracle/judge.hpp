// The engine's overlay of a pair, judged by the exact one.
#pragma once

#include <string>

#include "lober/overlay/overlay.hpp"
#include "tests/oracle/exact_overlay.hpp"
#include "tests/oracle/families.hpp"

namespace lober::oracle {

/// Areas above `large_area` of the bounding box (of both curves) have to be right to `large_error` of
/// themselves, smaller ones to `large_area * large_error` of the bounding box.
inline constexpr double large_area = 1e-12;
inline constexpr double large_error = 1e-15;
/// Below this, in squared units, the error terms of products underflow and nothing is asked but the counts.
inline constexpr double area_underflow = 1e-290;

struct Verdict {
  std::string complaints;     ///< one a line; empty if the engine is right
  double relative_error = 0;  ///< the worst of the large areas, relative to the area
  double small_error = 0;     ///< the worst of the small ones, relative to the bounding box
  double point_error = 0;     ///< the worst of the nodes' points, relative to the largest coordinate
};

/// Compares counts, the sequence of nodes along C1, classes, totals, and every piece's area and holes.
[[nodiscard]] Verdict judge(const CurvePair& pair, const ExactOverlay& exact, const Overlay& found);

/// Runs oracle and engine on the pair; what they throw becomes a complaint.
[[nodiscard]] Verdict try_pair(const CurvePair& pair);

}  // namespace lober::oracle
