// General overlay libraries, and the method of Naik, Lekien & Ross (2017), asked for the same answer.
//
// Each computes all four pairings, A1 \ A2, A2 \ A1, intersection and union, with their pieces. Only the
// overlays are timed: bringing the points into the library's own form before and counting and measuring the
// pieces after is not.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "kernels/point.hpp"

namespace lober::bench {
using namespace lober::detail;

struct RivalResult {
  bool ran = false;
  double seconds = 0;               ///< all four pairings
  double intersection_seconds = 0;  ///< the intersection alone, where it is computed apart
  double areas[4] = {};             ///< in the order of lober::all_pairings
  std::size_t pieces[4] = {};
  std::string note;  ///< why it did not run, or what to know about the numbers
};

using RivalFunction = RivalResult (*)(std::span<const Point> first, std::span<const Point> second);

struct Rival {
  std::string_view name;
  RivalFunction run;
  std::size_t largest;  ///< points per curve beyond which it is not even tried
  bool fast;            ///< fast enough to be tried on full scenes; the others see small ones only
  bool exact;           ///< its areas are those of exact arithmetic
  bool quadratic;       ///< time grows with the square of the number of points
};

[[nodiscard]] std::span<const Rival> rivals();

RivalResult run_geos(std::span<const Point> first, std::span<const Point> second);
RivalResult run_boost(std::span<const Point> first, std::span<const Point> second);
RivalResult run_cgal(std::span<const Point> first, std::span<const Point> second);
RivalResult run_quadratic(std::span<const Point> first, std::span<const Point> second);

}  // namespace lober::bench
