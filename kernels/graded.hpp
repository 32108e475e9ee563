// Points along segments of a guide, at a density that varies linearly along each.
#pragma once

#include <cstddef>

namespace lober::detail {

/// Segments in a row of a guide are handed over in no more than this number at a time.
inline constexpr std::size_t max_graded = 256;

/// `count` segments, at most max_graded: point k of the guide has parameters[k] (ascending) and index[k], which is
/// where it comes among the new points, whose indices are whole numbers.
struct GradedRow {
  const double* parameters;
  const double* index;     ///< ascending; of count + 1 points, as the parameters
  const double* required;  ///< new points that each segment requires, a real number
  const double* around;    ///< such points per parameter around each of the count + 1 points; negative at corners
  std::size_t count;
};

/// Sets places[n], the parameter of new point n, for each n whose index lies in the row: from that of the first point
/// on, and before that of the last one. The density goes from `around` at one end of a segment to that at the other,
/// each within a factor of 4 of the segment's own, which it is at corners.
void place_graded(const GradedRow& row, double* places);

}  // namespace lober::detail
