// Body of turns_along and parts_needed (kernels/all.inl).
#pragma once

#include "kernels/turning.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t turns_at_once = 256;

// Step by step over arrays and without a branch, so that compilers make vectors of it.
inline void turns_of_few(const Point* points, std::size_t segments, double* lengths, double* curvatures) {
  double x[turns_at_once + 1], y[turns_at_once + 1];
  for (std::size_t k = 0; k < segments; ++k) {
    x[k] = points[k + 1].x - points[k].x;
    y[k] = points[k + 1].y - points[k].y;
    lengths[k] = std::sqrt(x[k] * x[k] + y[k] * y[k]);
  }
  for (std::size_t k = 0; k + 1 < segments; ++k) {
    const double sine = std::fabs(x[k] * y[k + 1] - y[k] * x[k + 1]), both = lengths[k] * lengths[k + 1];
    const double below = both + (x[k] * x[k + 1] + y[k] * y[k + 1]);
    // The turning is 2 sine / below, cut off; one division for it and the mean length.
    const bool is_cut_off = !(2 * sine < 4 * below);
    const double most = both > 0 ? 8.0 : 0.0, turning = is_cut_off ? most : 4 * sine;
    const double curvature = turning / ((is_cut_off ? 1.0 : below) * (lengths[k] + lengths[k + 1]));
    curvatures[k] = turning > 0 ? curvature : 0.0;
  }
}

// In steps that share a segment, for the vertex between them.
inline void all_turns_along(const Point* points, std::size_t segments, double* lengths, double* curvatures) {
  for (std::size_t k = 0; k < segments; k += turns_at_once) {
    const std::size_t rest = segments - k;
    turns_of_few(points + k, rest < turns_at_once + 1 ? rest : turns_at_once + 1, lengths + k, curvatures + k);
  }
}

inline void all_parts_needed(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked,
                             double* parts) {
  const double per_tolerance = 1 / (8 * asked.tolerance), per_longest = 1 / asked.max_length;
  for (std::size_t k = 0; k < count; ++k) {
    const double larger = curvatures[k] > curvatures[k + 1] ? curvatures[k] : curvatures[k + 1];
    const double curvature = larger > 0 ? larger : 0.0;
    const double by_bulge = std::sqrt(curvature * lengths[k] * lengths[k] * per_tolerance);
    const double by_length = lengths[k] * per_longest;
    const double needed = by_bulge > by_length ? by_bulge : by_length;
    parts[k] = needed < asked.max_parts ? needed : asked.max_parts;
  }
}

}  // namespace
}  // namespace lober::detail
