// The planar subdivision that two simple closed polygons induce, by brute force in exact arithmetic.
//
// Every pair of segments is intersected, both curves are split wherever they meet, equal pieces of both
// become one edge, and the faces are traced around the vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/oracle/exact_curve.hpp"
#include "tests/oracle/exact_number.hpp"

namespace lober::oracle {

/// Coordinates in units of the curves' grid.
struct ExactPoint {
  Rational x, y;
};

/// A piece of one curve, or of both, between neighbouring vertices; `from` is the lexicographically smaller.
struct SubEdge {
  std::uint32_t from = 0, to = 0;
  std::array<int, 2> along{};  ///< per curve: +1 it runs from -> to, -1 to -> from, 0 it is elsewhere
  std::uint8_t curve = 0;      ///< a curve and its segment that carry the edge, for the direction
  std::uint32_t segment = 0;
};

struct Face {
  Rational area;  ///< in grid units; 0 for the unbounded face
  bool bounded = true;
  std::array<bool, 2> inside{};  ///< per curve
};

struct Arrangement {
  std::array<ExactCurve, 2> curves;
  std::vector<ExactPoint> points;  ///< sorted lexicographically, distinct
  std::vector<SubEdge> edges;
  std::array<std::vector<std::uint32_t>, 2> chain;        ///< per curve: its vertices, from its vertex 0
  std::array<std::vector<std::uint32_t>, 2> chain_edges;  ///< edge k joins chain[k] and chain[k + 1]
  std::vector<std::uint32_t> left;  ///< face to the left of half-edge 2 e (from -> to) and 2 e + 1 (to -> from)
  std::vector<Face> faces;          ///< face 0 is the unbounded one

  [[nodiscard]] const Face& left_face(std::size_t half_edge) const { return faces[left[half_edge]]; }
};

/// Requires simple curves. Throws std::logic_error when the subdivision contradicts itself (it cannot, if
/// they are).
[[nodiscard]] Arrangement arrange(std::span<const Point> first, std::span<const Point> second);

}  // namespace lober::oracle
