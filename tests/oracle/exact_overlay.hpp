// The exact overlay of two simple closed polygons, by brute force: what the engine has to find.
//
// Written from the definitions, sharing nothing with the engine but the struct Point. O(n m), a fraction of a
// millisecond for two 12-gons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/point.hpp"
#include "tests/oracle/exact_number.hpp"

namespace lober::oracle {
using namespace lober::detail;

/// The pairings by number, in the order of every array of four below.
enum : std::size_t { c1_minus_c2 = 0, c2_minus_c1 = 1, intersection = 2, union_ = 3 };

/// A connected component of the interior of the regularised region.
struct ExactPiece {
  Rational area;
  unsigned holes = 0;  ///< bounded connected components of the interior of the complement
};

/// A connected component of C1 n C2: a point or a shared arc.
struct ExactNode {
  int rho = 0;              ///< +1 C1 leaves A2 going counter-clockwise, -1 it enters, 0 it stays on one side
  int shared = 0;           ///< 0 a point; an arc: +1 same direction, -1 opposite (both counter-clockwise)
  std::uint32_t orbit = 0;  ///< of sigma, numbered by first appearance; `no_orbit` unless a crossing
  Point begin, end;         ///< in the caller's direction of C1, rounded to nearest
};
inline constexpr std::uint32_t no_orbit = 0xffffffff;

struct ExactOverlay {
  Rational area1, area2;
  std::array<Rational, 4> areas;                  ///< per pairing, from area1, area2 and the pieces of the intersection
  std::array<std::vector<ExactPiece>, 4> pieces;  ///< per pairing, largest first
  /// In the caller's order of C1 from its vertex 0, by where they begin. A wholly shared curve is one arc.
  std::vector<ExactNode> nodes;
  std::size_t crossings = 0;    ///< nodes with rho != 0, points or arcs
  std::size_t touches = 0;      ///< points with rho == 0
  std::size_t shared_arcs = 0;  ///< arcs, whatever their rho
  std::size_t orbits = 0;       ///< the classes of sigma
  bool same_curve = false;      ///< C1 and C2 are one set of points
};

/// Requires simple curves (`is_simple`). Throws std::logic_error when the answer contradicts itself.
[[nodiscard]] ExactOverlay exact_overlay(std::span<const Point> first, std::span<const Point> second);

}  // namespace lober::oracle
