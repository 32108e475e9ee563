#include "engine/geometry/overlay/box_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lober::detail {
namespace {

// The position of a cell of a grid of 2^16 x 2^16 along the Hilbert curve.
std::uint32_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0;
  for (std::uint32_t side = 1U << 15; side > 0; side >>= 1) {
    const std::uint32_t right = (x & side) != 0 ? 1 : 0, upper = (y & side) != 0 ? 1 : 0;
    position += side * side * ((3 * right) ^ upper);
    if (upper != 0) continue;
    if (right == 1) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return position;
}

// Halves are taken first: sums of coordinates may overflow.
double centre_of(double low, double high) {
  return 0.5 * low + 0.5 * high;
}

std::uint32_t hilbert_cell(double value, double low, double high) {
  const double part = (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low);
  return part > 0 ? static_cast<std::uint32_t>(std::min(part, 1.0) * 65535) : 0;  // NaN too
}

}  // namespace

BoxSet::BoxSet(std::span<const Box> boxes) : numbers_(boxes.size()) {
  Box whole;
  for (const Box& box : boxes) whole = union_of(whole, box);
  std::vector<std::uint32_t> positions;
  positions.reserve(boxes.size());
  for (const Box& box : boxes) {
    const std::uint32_t x = hilbert_cell(centre_of(box.min_x(), box.max_x()), whole.min_x(), whole.max_x());
    positions.push_back(
        hilbert_position(x, hilbert_cell(centre_of(box.min_y(), box.max_y()), whole.min_y(), whole.max_y())));
  }
  std::iota(numbers_.begin(), numbers_.end(), 0U);
  std::sort(numbers_.begin(), numbers_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return positions[a] != positions[b] ? positions[a] < positions[b] : a < b;
  });
  std::vector<Box> level;
  level.reserve(boxes.size());
  for (const std::uint32_t number : numbers_) level.push_back(boxes[number]);
  levels_.push_back(std::move(level));
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> next((below.size() + fan_out - 1) / fan_out);
    for (std::size_t k = 0; k < below.size(); ++k) next[k / fan_out] = union_of(next[k / fan_out], below[k]);
    levels_.push_back(std::move(next));
  }
}

void BoxSet::find(const Box& query, std::vector<std::uint32_t>& found) const {
  if (!numbers_.empty()) descend(query, levels_.size() - 1, 0, found);
}

void BoxSet::descend(const Box& query, std::size_t level, std::size_t node, std::vector<std::uint32_t>& found) const {
  if (!meet(levels_[level][node], query)) return;
  if (level == 0) return found.push_back(numbers_[node]);
  const std::size_t end = std::min((node + 1) * fan_out, levels_[level - 1].size());
  for (std::size_t k = node * fan_out; k < end; ++k) descend(query, level - 1, k, found);
}

}  // namespace lober::detail
