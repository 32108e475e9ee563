// Diagnostics of growth, by cause: for the reports on manifolds and on images of curves.
#pragma once

#include <cstddef>
#include <span>

#include "lober/dynamics/manifolds.hpp"

namespace lober::cli {

/// The number of segments with a diagnostic of this cause.
[[nodiscard]] inline std::size_t segments_with(std::span<const GrowthDiagnostic> diagnostics,
                                               GrowthDiagnosticCause cause) {
  std::size_t sum = 0;
  for (const GrowthDiagnostic& diagnostic : diagnostics) {
    if (diagnostic.cause == cause) sum += diagnostic.count;
  }
  return sum;
}

/// Where the first diagnostic of this cause is, on a manifold or an image of a curve; the origin where there is none.
template <typename Grown>
[[nodiscard]] Point first_point_with(const Grown& grown, GrowthDiagnosticCause cause) {
  for (const GrowthDiagnostic& diagnostic : grown.diagnostics) {
    if (diagnostic.cause == cause) return grown.points[diagnostic.first];
  }
  return {};
}

}  // namespace lober::cli
