// A second exact overlay, from CGAL: arrangements of segments over its exact kernel, overlaid by its sweep.
//
// CGAL supplies all the geometry: both subdivisions, their overlay, which faces border on which. Only the
// definition of a piece (faces joined across edges, docs/conventions.md, section 4) is ours, because CGAL's polygon
// sets join polygons that touch in a vertex and so cannot be compared.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/point.hpp"
#include "tests/oracle/exact_number.hpp"

namespace lober::oracle {
using namespace lober::detail;

struct CgalPiece {
  Rational area;
  unsigned holes = 0;
};

struct CgalOverlay {
  std::array<Rational, 4> areas;                 ///< per pairing, numbered as in exact_overlay.hpp
  std::array<std::vector<CgalPiece>, 4> pieces;  ///< largest first
  std::size_t faces = 0;                         ///< of the overlay, the unbounded one included
};

/// Requires simple polygons. Small ones: milliseconds for two 12-gons.
[[nodiscard]] CgalOverlay cgal_overlay(std::span<const Point> first, std::span<const Point> second);

}  // namespace lober::oracle
