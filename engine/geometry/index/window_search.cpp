// Where a curve is folded upon itself many times, the pieces of it that lie in a window are folds side by side. A
// function of the place whose level lines follow them (kernels/fold_chart.hpp) gives each piece an interval of heights;
// sorted by these, pieces of the same height are neighbours in the list, and all others are apart. In a window that is
// too large for one such function, pieces are level with many; it is split.

#include "engine/geometry/index/window_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/fold_chart.hpp"

namespace lober::detail {
namespace {

// A window is split where leaves are level with more others than these, on average, as far as a few of them show; where
// it takes more comparisons than these, a leaf; and where more pairs than these remain.
constexpr double max_level = 16;
constexpr std::size_t max_compared = 32, max_met = 2;
// Where splitting does not help either, many leaves lie across each other, and those that meet are not worth listing
// from this number on, a leaf.
constexpr std::size_t max_listed = 256;
// In windows of as few leaves everything is compared.
constexpr std::size_t smallest = 64;

struct LeafPair {
  std::uint32_t first, second;
};

struct Charted {
  ChartedLeaf at;
  std::uint32_t leaf;
};
bool is_lower(const Charted& a, const Charted& b) {
  return a.at.low < b.at.low || (a.at.low == b.at.low && a.leaf < b.leaf);
}

// Sorts by `low`: into as many equal steps as there are leaves, then within these.
void sort_by_height(const Buffer<Charted>& from, std::size_t count, Buffer<Charted>& sorted) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (std::size_t k = 0; k < count; ++k) {
    if (std::isfinite(from[k].at.low)) least = std::min(least, from[k].at.low);
    greatest = std::max(greatest, from[k].at.low);
  }
  const double last = static_cast<double>(count) - 1, steps = last / (greatest - least);
  const double scale = std::isfinite(steps) ? steps : 0;
  const auto step_of = [&](const Charted& leaf) {
    const double step = (leaf.at.low - least) * scale;
    return static_cast<std::size_t>(step > 0 ? std::min(step, last) : 0);  // an infinite `low` is the least
  };
  std::vector<std::uint32_t> end(count + 1);
  for (std::size_t k = 0; k < count; ++k) ++end[step_of(from[k]) + 1];
  for (std::size_t k = 0; k < count; ++k) end[k + 1] += end[k];
  sorted.resize(count);
  for (std::size_t k = 0; k < count; ++k) sorted[end[step_of(from[k])]++] = from[k];
  for (std::size_t k = 0, begin = 0; k < count; begin = end[k++]) {
    if (end[k] > begin + 2) {
      std::sort(sorted.data() + begin, sorted.data() + end[k], is_lower);
    } else if (end[k] == begin + 2 && is_lower(sorted[begin + 1], sorted[begin])) {
      std::swap(sorted[begin], sorted[begin + 1]);
    }
  }
}

// The part of a leaf that lies in a window, as one chord.
struct Piece {
  Point middle, chord;
};
Piece piece_in(const Point* points, const Box& window) {
  const auto is_in = [&](Point p) { return meet(Box::of(p, p), window); };
  std::size_t first = 0, last = leaf_size;
  while (first < last && !is_in(points[first])) ++first;
  while (last > first && !is_in(points[last])) --last;
  if (first == last) {
    first -= first > 0 ? 1 : 0;
    last += last < leaf_size ? 1 : 0;
  }
  const Point from = points[first], to = points[last];
  return {{0.5 * from.x + 0.5 * to.x, 0.5 * from.y + 0.5 * to.y}, {to.x - from.x, to.y - from.y}};
}

// Four normal equations, a little regularised. Zeros where that gives no numbers.
using Equations = std::array<std::array<double, 5>, 4>;
std::array<double, 4> solved(Equations rows) {
  const double trace = rows[0][0] + rows[1][1] + rows[2][2] + rows[3][3];
  for (std::size_t k = 0; k < 4; ++k) rows[k][k] += 1e-5 * trace;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = k + 1; i < 4; ++i) {
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < 5; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::array<double, 4> x{};
  for (std::size_t k = 4; k-- > 0;) {
    double value = rows[k][4];
    for (std::size_t j = k + 1; j < 4; ++j) value -= rows[k][j] * x[j];
    x[k] = value / rows[k][k];
  }
  if (!std::isfinite(x[0] + x[1] + x[2] + x[3])) return {};
  return x;
}

// The chart whose level lines follow these pieces best, by least squares: its gradient has no part along a chord.
FoldChart fit_chart(std::span<const Piece> pieces, const Box& window) {
  FoldChart chart{{0.5 * window.min_x() + 0.5 * window.max_x(), 0.5 * window.min_y() + 0.5 * window.max_y()}, {1, 0}};
  // Their mean direction, either sense of a chord being the same: a mean of doubled angles.
  Point doubled{0, 0};
  for (const Piece& piece : pieces) {
    const auto [x, y] = piece.chord;
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) continue;
    doubled.x += (x * x - y * y) / length;
    doubled.y += 2 * x * y / length;
  }
  const double length = std::sqrt(doubled.x * doubled.x + doubled.y * doubled.y);
  const double unit = 0.5 * std::max(window.width(), window.height());
  if (!(length > 0 && std::isfinite(length) && unit > 0)) return chart;
  const double cosine = doubled.x / length;
  const double ax = std::sqrt(std::max(0.0, 0.5 * (1 + cosine)));
  const double ay = std::copysign(std::sqrt(std::max(0.0, 0.5 * (1 - cosine))), doubled.y);
  chart.along = {ax, ay};
  Equations rows{};
  for (const Piece& piece : pieces) {
    const double x = (piece.middle.x - chart.at.x) / unit, y = (piece.middle.y - chart.at.y) / unit;
    const double dx = piece.chord.x / unit, dy = piece.chord.y / unit;
    const double u = ax * x + ay * y, v = ax * y - ay * x, du = ax * dx + ay * dy, dv = ax * dy - ay * dx;
    const double size = std::sqrt(du * du + dv * dv);
    if (!(size > 0)) continue;
    // du (slope + 2 bend u + shear v) + dv (1 + shear u + 2 bow v) = 0
    const std::array<double, 5> row{du, 2 * du * u, du * v + dv * u, 2 * dv * v, -dv};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 5; ++j) rows[i][j] += row[i] * row[j] / size;
    }
  }
  const std::array<double, 4> found = solved(rows);
  if (!(std::fabs(found[0]) <= 4)) return chart;
  chart.slope = found[0];
  chart.bend = found[1] / unit;
  chart.shear = found[2] / unit;
  chart.bow = found[3] / unit;
  return chart;
}

// The leaves that a window has to do with.
class Window {
 public:
  Window(const BoxTree& tree, const Box& window, std::vector<std::uint32_t> leaves)
      : tree_(tree), window_(window), leaves_(std::move(leaves)) {}

  // All pairs of leaves that may meet in the window, which is split as long as that helps; none where they are too
  // many. A pair of neighbours may be missing where it cannot meet but in the end that they share.
  std::optional<std::vector<LeafPair>> search(SearchCounts& counts) {
    if (leaves_.empty()) return std::vector<LeafPair>{};
    const FoldChart chart = fitting();
    const bool is_small = leaves_.size() <= smallest;
    if (is_small || on_one_level(chart, counts) <= max_level) {
      if (auto found = compare(chart, is_small ? smallest : max_met, is_small ? smallest : max_compared, counts)) {
        return found;
      }
    }
    std::optional<std::array<Window, 2>> halves = split();
    if (!halves && leave_out(chart)) return search(counts);
    if (!halves) return compare(chart, max_listed, std::numeric_limits<std::uint32_t>::max(), counts);
    leaves_ = {};
    std::array<std::optional<std::vector<LeafPair>>, 2> found;
    std::array<SearchCounts, 2> half_counts;
    for_each_block(2, 1, [&](std::size_t k, std::size_t) { found[k] = (*halves)[k].search(half_counts[k]); });
    for (const SearchCounts& half : half_counts) counts += half;
    if (!found[0] || !found[1]) return std::nullopt;
    found[0]->insert(found[0]->end(), found[1]->begin(), found[1]->end());
    return std::move(found[0]);
  }

 private:
  // Number k of `count` leaves, all where there are no more. Equal steps would meet each fold in the same place.
  [[nodiscard]] std::uint32_t sample(std::size_t k, std::size_t count) const {
    if (count == leaves_.size()) return leaves_[k];
    constexpr std::uint32_t golden = 0x9e3779b9;
    const std::uint32_t part = static_cast<std::uint32_t>(k) * golden;
    return leaves_[static_cast<std::uint64_t>(part) * leaves_.size() >> 32U];
  }

  void measure(std::uint32_t leaf, const FoldChart& chart, ChartedLeaf& at) const {
    chart_leaf(tree_.leaf_points(leaf), tree_.leaf_boxes()[leaf], window_, chart, at);
  }

  [[nodiscard]] FoldChart fitting() const {
    std::array<Piece, 16> pieces;
    const std::size_t count = std::min(pieces.size(), leaves_.size());
    for (std::size_t k = 0; k < count; ++k) pieces[k] = piece_in(tree_.leaf_points(sample(k, count)), window_);
    return fit_chart({pieces.data(), count}, window_);
  }

  // Leaves out those of which the box alone reaches into the window, if they are many.
  [[nodiscard]] bool leave_out(const FoldChart& chart) {
    std::vector<std::uint32_t> inside;
    for (const std::uint32_t leaf : leaves_) {
      ChartedLeaf at;
      measure(leaf, chart, at);
      if (at.is_inside) inside.push_back(leaf);
    }
    if (inside.size() > leaves_.size() * 9 / 10) return false;
    leaves_ = std::move(inside);
    return true;
  }

  // How many others a leaf is level with, judged by some.
  [[nodiscard]] double on_one_level(const FoldChart& chart, SearchCounts& counts) const {
    const std::size_t count = std::min<std::size_t>(32, leaves_.size());
    double sum = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < count; ++k) {
      ChartedLeaf at;
      measure(sample(k, count), chart, at);
      if (!at.is_inside) continue;
      sum += at.high - at.low;
      low = std::min(low, at.low);
      high = std::max(high, at.high);
    }
    counts.boxes_tested += count;
    if (!(high > low)) return 0;
    return 2 * sum / (high - low) * (static_cast<double>(leaves_.size()) / static_cast<double>(count));
  }

  // The pairs that neither heights nor places along the chart tell apart; none when they or the comparisons are more
  // than that many a leaf.
  [[nodiscard]] std::optional<std::vector<LeafPair>> compare(const FoldChart& chart, std::size_t max_pairs,
                                                             std::size_t max_tests, SearchCounts& counts) const {
    constexpr std::size_t ahead = 3;
    Buffer<Charted> unsorted(leaves_.size()), charted;
    std::size_t count = 0;
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
      tree_.prefetch_leaf(leaves_[std::min(k + ahead, leaves_.size() - 1)]);
      unsorted[count].leaf = leaves_[k];
      measure(leaves_[k], chart, unsorted[count].at);
      count += unsorted[count].at.is_inside ? 1 : 0;
    }
    sort_by_height(unsorted, count, charted);
    std::vector<LeafPair> found;
    std::size_t compared = 0;
    bool is_bounded = true;
    for (std::size_t k = 0; k < count && is_bounded; ++k) {
      const Charted& one = charted[k];
      if (!apart(one, one)) found.push_back({one.leaf, one.leaf});
      std::size_t j = k + 1;
      for (; j < count && charted[j].at.low <= one.at.high; ++j) {
        const Charted& other = charted[j];
        if (other.at.left > one.at.right || other.at.right < one.at.left) continue;
        const bool in_order = one.leaf < other.leaf;
        const Charted &first = in_order ? one : other, &second = in_order ? other : one;
        if (!apart(first, second)) found.push_back({first.leaf, second.leaf});
      }
      compared += j - k;
      is_bounded = found.size() <= max_pairs * leaves_.size() && compared <= max_tests * leaves_.size();
    }
    counts.boxes_tested += leaves_.size() + compared;
    if (!is_bounded) return std::nullopt;
    return found;
  }

  // Nothing to find between the two: they are one run that is monotone along an axis or along the chart.
  [[nodiscard]] bool apart(const Charted& first, const Charted& second) const {
    const bool wraps = first.leaf == 0 && second.leaf + 1 == tree_.leaves() && tree_.curve().closed;
    if (second.leaf - first.leaf > 1 && !wraps) return false;
    if ((first.at.rises && second.at.rises) || (first.at.falls && second.at.falls)) return true;
    return (tree_.flags({0, first.leaf}) & tree_.flags({0, second.leaf})) != 0;
  }

  // In the middle of its leaves, along the axis where the fewest are cut, as far as some of them show; none if that
  // does not part them.
  [[nodiscard]] std::optional<std::array<Window, 2>> split() const {
    std::array<double, 64> centres;
    const std::size_t count = std::min(centres.size(), leaves_.size());
    std::size_t axis = 0, least_cut = count + 1;
    double middle = 0;
    for (std::size_t candidate = 0; candidate < 2; ++candidate) {
      for (std::size_t k = 0; k < count; ++k) {
        const Box& box = tree_.leaf_boxes()[sample(k, count)];
        centres[k] = 0.5 * std::max(box.lane[candidate], window_.lane[candidate]) -
                     0.5 * std::max(box.lane[candidate + 2], window_.lane[candidate + 2]);
      }
      const auto half = centres.begin() + static_cast<std::ptrdiff_t>(count / 2);
      std::nth_element(centres.begin(), half, centres.begin() + static_cast<std::ptrdiff_t>(count));
      std::size_t cut = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const Box& box = tree_.leaf_boxes()[sample(k, count)];
        cut += box.lane[candidate] <= *half && -box.lane[candidate + 2] >= *half ? 1 : 0;
      }
      if (cut >= least_cut) continue;
      least_cut = cut;
      axis = candidate;
      middle = *half;
    }
    std::array<Box, 2> windows{window_, window_};
    windows[0].lane[axis + 2] = -middle;
    windows[1].lane[axis] = middle;
    std::array<std::vector<std::uint32_t>, 2> in;
    for (auto& leaves : in) leaves.resize(leaves_.size());
    std::size_t before = 0, behind = 0;
    for (const std::uint32_t leaf : leaves_) {
      const Box& box = tree_.leaf_boxes()[leaf];
      in[0][before] = in[1][behind] = leaf;
      before += box.lane[axis] <= middle ? 1 : 0;
      behind += -box.lane[axis + 2] >= middle ? 1 : 0;
    }
    if (std::max(before, behind) > leaves_.size() * 9 / 10 || before + behind > leaves_.size() * 3 / 2) return {};
    in[0].resize(before);
    in[1].resize(behind);
    return std::array<Window, 2>{Window(tree_, windows[0], std::move(in[0])),
                                 Window(tree_, windows[1], std::move(in[1]))};
  }

  const BoxTree& tree_;
  Box window_;
  std::vector<std::uint32_t> leaves_;  // ascending
};

}  // namespace

NearLeaves::NearLeaves(const BoxTree& tree, SearchCounts& counts) {
  std::vector<std::uint32_t> leaves;
  leaves.reserve(tree.leaves());
  for (std::uint32_t k = 0; k < tree.leaves(); ++k) {
    if (!is_point(tree.leaf_boxes()[k])) leaves.push_back(k);
  }
  const std::optional<std::vector<LeafPair>> pairs = Window(tree, tree.box(), std::move(leaves)).search(counts);
  is_complete_ = pairs.has_value();
  if (!is_complete_) return;
  begin_.resize(tree.leaves() + 1);
  for (const LeafPair& pair : *pairs) ++begin_[pair.first + 1];
  for (std::size_t k = 0; k < tree.leaves(); ++k) begin_[k + 1] += begin_[k];
  end_.assign(begin_.begin(), begin_.end() - 1);
  others_.resize(pairs->size());
  for (const LeafPair& pair : *pairs) others_[end_[pair.first]++] = {0, pair.second};
  // Windows beside each other find some twice.
  for (std::size_t k = 0; k < tree.leaves(); ++k) {
    const auto first = others_.begin() + begin_[k], last = others_.begin() + end_[k];
    std::sort(first, last, [](TreeNode a, TreeNode b) { return a.index < b.index; });
    end_[k] = static_cast<std::uint32_t>(std::unique(first, last) - others_.begin());
  }
}

}  // namespace lober::detail
