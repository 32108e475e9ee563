// The exact areas of a case, by two oracles, and the file that records them.
#pragma once

#include <array>
#include <string>

#include "tests/oracle/exact_number.hpp"
#include "tests/trust/tracker_case.hpp"

namespace lober::trust {

/// A case as curves, with its areas as rational numbers.
struct ExactCase {
  std::vector<Point> c1, c2;
  bool simple = false;                             ///< both are simple curves, as lober::overlay wants them
  std::array<oracle::Rational, area_count> areas;  ///< by vertical slabs (slab_arrangement.hpp)
  oracle::Rational intersection_by_trapezoids;     ///< the same without crossings (trapezoid_area.hpp)
};

[[nodiscard]] ExactCase exact_case(const TrackerCase& given);

/// To 30 significant digits, rounded.
[[nodiscard]] std::string digits(const oracle::Rational& area);

/// The whole file: the lines written by hand, then the command, the areas and the zones.
[[nodiscard]] std::string case_text(const TrackerCase& given, const ExactCase& exact);

}  // namespace lober::trust
