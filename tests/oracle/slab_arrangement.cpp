#include "tests/oracle/slab_arrangement.hpp"

#include <algorithm>
#include <set>

#include "kernels/box.hpp"
#include "tests/oracle/disjoint_sets.hpp"

namespace lober::oracle {
using namespace lober::detail;

// A segment from left to right; `winding` is what crossing it upwards adds.
struct SlabArrangement::Line {
  Rational x0, y0, x1, y1, slope;
  int winding1, winding2;
  [[nodiscard]] Rational at(const Rational& x) const { return y0 + slope * (x - x0); }
};

SlabArrangement::SlabArrangement(std::span<const Point> first, std::span<const Point> second) {
  std::vector<Line> lines;
  std::set<Rational> borders;
  const auto add = [&](std::span<const Point> points, int winding1, int winding2) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point& a = points[k];
      const Point& b = points[k + 1 == points.size() ? 0 : k + 1];
      borders.insert(Rational(a.x));
      if (a.x == b.x) continue;  // vertical segments are no sides of trapezoids
      const bool right = a.x < b.x;
      const Point &l = right ? a : b, &r = right ? b : a;
      Line line{Rational(l.x),
                Rational(l.y),
                Rational(r.x),
                Rational(r.y),
                {},
                right ? winding1 : -winding1,
                right ? winding2 : -winding2};
      line.slope = (line.y1 - line.y0) / (line.x1 - line.x0);
      lines.push_back(line);
    }
  };
  add(first, 1, 0);
  add(second, 0, 1);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Line &p = lines[i], &q = lines[j];
      if (p.slope == q.slope || p.x1 <= q.x0 || q.x1 <= p.x0) continue;
      const Rational x = (q.at(0) - p.at(0)) / (p.slope - q.slope);
      if (x > p.x0 && x < p.x1 && x > q.x0 && x < q.x1) borders.insert(x);
    }
  }

  cells_.push_back({0, 0, 0});
  last_cells_ = {0};
  auto left = borders.begin();
  for (auto right = std::next(left); right != borders.end(); left = right++) {
    std::vector<Line> inside;
    for (const Line& line : lines) {
      if (line.x0 <= *left && line.x1 >= *right) inside.push_back(line);
    }
    add_slab(*left, *right, inside);
  }
  join_to_last({0}, {});  // the outside is one, left and right
}

void SlabArrangement::add_slab(const Rational& left, const Rational& right, const std::vector<Line>& lines) {
  struct Side {
    Rational at_left, at_right, sum;  // heights, and their sum
    int winding1, winding2;
  };
  std::vector<Side> sides;
  for (const Line& line : lines) {
    Side side{line.at(left), line.at(right), {}, line.winding1, line.winding2};
    side.sum = side.at_left + side.at_right;
    sides.push_back(std::move(side));
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) { return x.sum < y.sum; });

  // Cells between the sides, sides at the same height all along taken together.
  std::vector<std::size_t> cells{cells_.size()};
  std::vector<Rational> heights_left, heights_right;
  cells_.push_back({0, 0, 0});
  for (std::size_t k = 0; k < sides.size();) {
    Cell above = cells_.back();
    std::size_t end = k;
    for (; end < sides.size() && sides[end].sum == sides[k].sum; ++end) {
      above.winding1 += sides[end].winding1;
      above.winding2 += sides[end].winding2;
    }
    above.area = 0;
    if (end < sides.size()) {
      above.area = (sides[end].sum - sides[k].sum) * (right - left) / 2;
      if (above.winding1 != 0 || above.winding2 != 0) areas_[{above.winding1, above.winding2}] += above.area;
    }
    heights_left.push_back(sides[k].at_left);
    heights_right.push_back(sides[k].at_right);
    next_.emplace_back(cells_.size() - 1, cells_.size());
    cells.push_back(cells_.size());
    cells_.push_back(above);
    k = end;
  }

  join_to_last(cells, heights_left);
  last_cells_ = std::move(cells);
  last_heights_ = std::move(heights_right);
}

// Neighbours across a vertical line: walks up both lists of intervals.
void SlabArrangement::join_to_last(const std::vector<std::size_t>& cells, const std::vector<Rational>& heights) {
  std::size_t i = 0, j = 0;
  const Rational* from = nullptr;  // where the common interval begins; nullptr: nowhere
  while (true) {
    const bool ends_i = i < last_heights_.size(), ends_j = j < heights.size();
    const bool i_first = ends_i && (!ends_j || last_heights_[i] <= heights[j]);
    const Rational* to = i_first ? &last_heights_[i] : ends_j ? &heights[j] : nullptr;
    if (from == nullptr || to == nullptr || *from != *to) next_.emplace_back(last_cells_[i], cells[j]);
    if (to == nullptr) return;
    from = to;
    ++(i_first ? i : j);
  }
}

std::vector<SlabPiece> SlabArrangement::pieces(const std::function<bool(int, int)>& wanted) const {
  std::vector<char> in(cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    in[k] = wanted(cells_[k].winding1, cells_[k].winding2) ? 1 : 0;
  }
  DisjointSets sets(cells_.size());
  for (const auto& [x, y] : next_) {
    if (in[x] != 0 && in[y] != 0) sets.join(x, y);
  }
  std::map<std::size_t, SlabPiece> by_root;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    if (in[k] != 0) by_root[sets.find(k)].area += cells_[k].area;
  }
  std::vector<SlabPiece> result;
  for (auto& [root, piece] : by_root) {
    DisjointSets rest(cells_.size());
    const auto outside = [&, own = root](std::size_t cell) { return in[cell] == 0 || sets.find(cell) != own; };
    for (const auto& [x, y] : next_) {
      if (outside(x) && outside(y)) rest.join(x, y);
    }
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (outside(k) && rest.find(k) == k) ++piece.holes;
    }
    --piece.holes;  // the unbounded component
    result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace lober::oracle
