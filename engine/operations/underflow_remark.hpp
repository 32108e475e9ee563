// Areas of curves so small that double precision does not hold them (private to operations/).
#pragma once

#include <limits>

#include "lober/operations.hpp"
#include "lober/overlay/areas.hpp"

namespace lober::detail::table {
using namespace operations;

/// Adds a remark where the area of C1 or of C2 has underflowed: an area of zero may be read as that of no curve at all.
/// A bound on its rounding that is as small tells such an area from one that is zero.
inline void remark_on_underflow(const Areas& areas, const Areas& rounding, Outcome& outcome) {
  constexpr double least = std::numeric_limits<double>::min();
  const auto lost = [](double area, double bound) { return area < least && bound > 0 && bound < least; };
  if (!lost(areas.c1, rounding.c1) && !lost(areas.c2, rounding.c2)) return;
  outcome.remarks.emplace_back(
      "areas below 2.2e-308, the smallest number that double precision holds with all its digits, have lost digits or "
      "are 0; give coordinates in a smaller unit");
}

}  // namespace lober::detail::table
