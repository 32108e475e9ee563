// Winding numbers of two closed polygons of any shape, by vertical slabs: no node is identified, nothing is sorted
// round a point and no boundary is walked.
//
// Vertical lines through all vertices and all crossings cut the plane into slabs. In a slab no two segments cross, so
// they have an order, and between them lie trapezoids, the cells, whose winding numbers follow from counting from
// below.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "kernels/point.hpp"
#include "tests/oracle/exact_number.hpp"

namespace lober::oracle {
using namespace lober::detail;

struct SlabPiece {
  Rational area;
  int holes = 0;
};

class SlabArrangement {
 public:
  /// O(n^2) crossings, O(n^3) cells at worst.
  SlabArrangement(std::span<const Point> first, std::span<const Point> second);

  /// Exact area by pair of winding numbers, (0, 0) left out.
  [[nodiscard]] const std::map<std::pair<int, int>, Rational>& areas() const { return areas_; }

  /// The connected components of the interior of the closure of all cells that `wanted` takes by their winding numbers;
  /// (0, 0) must not be wanted. O(cells) for each.
  [[nodiscard]] std::vector<SlabPiece> pieces(const std::function<bool(int, int)>& wanted) const;

 private:
  struct Line;
  struct Cell {
    int winding1, winding2;
    Rational area;
  };
  void add_slab(const Rational& left, const Rational& right, const std::vector<Line>& lines);
  void join_to_last(const std::vector<std::size_t>& cells, const std::vector<Rational>& heights);

  std::vector<Cell> cells_;                                // number 0: left of everything
  std::vector<std::pair<std::size_t, std::size_t>> next_;  // cells with a common side of positive length
  // Cells along the last vertical line, from below, with the heights that separate them.
  std::vector<std::size_t> last_cells_;
  std::vector<Rational> last_heights_;
  std::map<std::pair<int, int>, Rational> areas_;
};

}  // namespace lober::oracle
