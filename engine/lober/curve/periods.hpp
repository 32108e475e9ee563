// Curves on cylinders and tori: followed across the seam, where a coordinate begins anew.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/point.hpp"

namespace lober {

/// The period of each coordinate; 0 for one that has none.
struct Periods {
  double x = 0;  ///< period of x, positive or 0
  double y = 0;  ///< period of y, positive or 0

  /// Whether a coordinate has a period.
  [[nodiscard]] bool any() const { return x != 0 || y != 0; }
};

/// Moves each point by whole periods to within half a period of the one before it, so that a curve that was stored
/// modulo the periods is continuous. The first point stays where it is; a step of exactly half a period is left.
/// Returns how many segments cross a seam. Throws UsageError for a period that is negative or not finite. O(n).
LOBER_API std::size_t unwrap(std::span<Point> points, Periods periods);

/// Moves all points by the same whole periods, so that the middle of their box is as near to that of the others as can
/// be. O(n).
LOBER_API void move_near(std::span<Point> points, std::span<const Point> others, Periods periods);

/// Says that two curves, as move_near has left them, are together wider than a period: they could also meet where one
/// of them is moved by that period, which no operation counts, so that areas and crossings may be incomplete. It names
/// the coordinate, and the curves where both have names. Empty where they are not, and without periods. O(N).
[[nodiscard]] LOBER_API std::string period_warning(const Curve& first, const Curve& second, Periods periods);

}  // namespace lober
