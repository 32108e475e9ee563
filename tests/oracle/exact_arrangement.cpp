#include "tests/oracle/exact_arrangement.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tests/oracle/exact_subdivision.hpp"

namespace lober::oracle {
namespace {

using Lists = std::array<std::vector<std::vector<std::uint32_t>>, 2>;

// The points on each segment, first as indices into an unsorted table: the vertices of curve 0, those of
// curve 1, then the proper crossings.
class Splitter {
 public:
  explicit Splitter(Arrangement& arrangement) : arrangement_(arrangement) {
    for (std::size_t c = 0; c < 2; ++c) {
      const ExactCurve& curve = arrangement_.curves[c];
      base_[c] = table_.size();
      for (std::size_t i = 0; i < curve.size(); ++i) table_.push_back({curve.x[i], curve.y[i]});
      on_[c].resize(curve.size());
      for (std::size_t i = 0; i < curve.size(); ++i) on_[c][i] = {vertex(c, i), vertex(c, curve.after(i))};
    }
  }

  void run() {
    const auto& [first, second] = arrangement_.curves;
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t j = 0; j < second.size(); ++j) {
        if (boxes_meet(first, i, second, j)) intersect(i, j);
      }
    }
    identify();
    for (std::size_t c = 0; c < 2; ++c) walk(c);
    merge_edges();
  }

 private:
  struct Run {
    std::uint64_t key;
    std::uint8_t curve;
    std::int8_t direction;
    std::uint32_t segment;
    std::uint32_t position;
  };

  [[nodiscard]] std::uint32_t vertex(std::size_t c, std::size_t i) const {
    return static_cast<std::uint32_t>(base_[c] + i);
  }

  // Notes every point that segment i of the first and j of the second curve share (for an overlap: its ends).
  void intersect(std::size_t i, std::size_t j) {
    const auto& [first, second] = arrangement_.curves;
    const std::size_t i_end = first.after(i);
    const std::size_t j_end = second.after(j);
    const int start2 = side(first, i, second, j);
    const int end2 = side(first, i, second, j_end);
    if (start2 * end2 > 0) return;
    const int start1 = side(second, j, first, i);
    const int end1 = side(second, j, first, i_end);
    if (start1 * end1 > 0) return;
    if (start1 * end1 < 0 && start2 * end2 < 0) {
      cross(i, j);
      return;
    }
    if (start2 == 0 && within_box(first, i, second.points[j])) on_[0][i].push_back(vertex(1, j));
    if (end2 == 0 && within_box(first, i, second.points[j_end])) on_[0][i].push_back(vertex(1, j_end));
    if (start1 == 0 && within_box(second, j, first.points[i])) on_[1][j].push_back(vertex(0, i));
    if (end1 == 0 && within_box(second, j, first.points[i_end])) on_[1][j].push_back(vertex(0, i_end));
  }

  void cross(std::size_t i, std::size_t j) {
    const auto& [first, second] = arrangement_.curves;
    // First curve's point a + t d with (e x (a + t d)) equal to the second segment's offset e x c.
    const Integer across = second.dx[j] * first.dy[i] - second.dy[j] * first.dx[i];
    const Integer missing = second.offset[j] - (second.dx[j] * first.y[i] - second.dy[j] * first.x[i]);
    Rational t(missing, across);
    t.canonicalize();
    const auto index = static_cast<std::uint32_t>(table_.size());
    table_.push_back({first.x[i] + t * first.dx[i], first.y[i] + t * first.dy[i]});
    on_[0][i].push_back(index);
    on_[1][j].push_back(index);
  }

  // Sorts the table, drops repeated points and renames the lists' entries: names then sort like the points.
  void identify() {
    const auto compare = [&](std::uint32_t a, std::uint32_t b) {
      const int order = cmp(table_[a].x, table_[b].x);
      return order != 0 ? order : cmp(table_[a].y, table_[b].y);
    };
    std::vector<std::uint32_t> order(table_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
    std::vector<std::uint32_t> name(table_.size());
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t index : order) {
      if (kept.empty() || compare(kept.back(), index) != 0) kept.push_back(index);
      name[index] = static_cast<std::uint32_t>(kept.size() - 1);
    }
    for (auto& lists : on_) {
      for (auto& list : lists) {
        for (std::uint32_t& entry : list) entry = name[entry];
      }
    }
    for (const std::uint32_t index : kept) arrangement_.points.push_back(std::move(table_[index]));
  }

  // The points of a segment lie on a line, so sorting them lexicographically sorts them along it.
  void walk(std::size_t c) {
    for (std::size_t i = 0; i < on_[c].size(); ++i) {
      std::vector<std::uint32_t>& list = on_[c][i];
      const bool forward = list[0] < list[1];
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      if (!forward) std::reverse(list.begin(), list.end());
      for (std::size_t k = 0; k + 1 < list.size(); ++k) {
        const auto [low, high] = std::minmax(list[k], list[k + 1]);
        runs_.push_back({(std::uint64_t{low} << 32U) | high, static_cast<std::uint8_t>(c),
                         static_cast<std::int8_t>(forward ? 1 : -1), static_cast<std::uint32_t>(i),
                         static_cast<std::uint32_t>(arrangement_.chain[c].size())});
        arrangement_.chain[c].push_back(list[k]);
      }
    }
    arrangement_.chain_edges[c].resize(arrangement_.chain[c].size());
  }

  void merge_edges() {
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.key < b.key; });
    std::uint64_t last = 0;
    for (const Run& run : runs_) {
      std::vector<SubEdge>& edges = arrangement_.edges;
      if (edges.empty() || run.key != last) {
        edges.push_back({static_cast<std::uint32_t>(run.key >> 32U),
                         static_cast<std::uint32_t>(run.key),
                         {},
                         run.curve,
                         run.segment});
      }
      last = run.key;
      edges.back().along[run.curve] = run.direction;
      arrangement_.chain_edges[run.curve][run.position] = static_cast<std::uint32_t>(edges.size() - 1);
    }
  }

  Arrangement& arrangement_;
  std::array<std::size_t, 2> base_{};
  std::vector<ExactPoint> table_;
  Lists on_;
  std::vector<Run> runs_;
};

}  // namespace

void split_curves(Arrangement& arrangement) {
  Splitter(arrangement).run();
}

Arrangement arrange(std::span<const Point> first, std::span<const Point> second) {
  const int exponent = common_exponent(first, second);
  Arrangement arrangement;
  arrangement.curves = {exact_curve(first, exponent), exact_curve(second, exponent)};
  split_curves(arrangement);
  trace_faces(arrangement);
  return arrangement;
}

}  // namespace lober::oracle
