#include "engine/geometry/interior/insert_points.hpp"

#include <algorithm>
#include <atomic>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/quantities.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t insertions_a_block = 4096;

// Where on one segment the curve changes its side.
struct SegmentSides {
  Side before;  // side before the first change
  std::span<const SideChange> changes;

  // At a change itself the curve is on the other one.
  [[nodiscard]] Side at(double t) const {
    const auto after = std::partition_point(changes.begin(), changes.end(),
                                            [&](const SideChange& change) { return change.at.t <= t; });
    if (after == changes.begin()) return before;
    return std::prev(after)->at.t == t ? Side::on : std::prev(after)->side;
  }
};

// The number of points of all blocks together.
class PointBudget {
 public:
  explicit PointBudget(std::size_t limit) : limit_(limit) {}
  void take(std::size_t points) {
    if (taken_.fetch_add(points) + points <= limit_) return;
    throw DataError("points inserted where labels change would make a curve of more than " + std::to_string(limit_) +
                    " points, the limit; give " + std::string(quantity::passes) + " instead");
  }

 private:
  std::atomic<std::size_t> taken_{0};
  std::size_t limit_;
};

class Inserter {
 public:
  Inserter(const Segment& segment, const SegmentSides& sides, int points, PointBudget& budget, LabelledCurve& target)
      : segment_(segment), sides_(sides), points_(points), budget_(budget), target_(target) {}

  // Appends what belongs strictly between parameters low and high, where the labels are as given.
  void insert(double low, double high, Side at_low, Side at_high, int passes) {
    const double step = (high - low) / (points_ + 1.0);
    constexpr double finest = 0x1p-52;  // beyond, neighbours would be the same point
    if (at_low == at_high || passes == 0 || step < finest) return;
    budget_.take(static_cast<std::size_t>(points_));
    double from = low;
    Side at_from = at_low;
    for (int k = 1; k <= points_; ++k) {
      const double to = low + k * step;
      const Point here{segment_.a.x + to * (segment_.b.x - segment_.a.x),
                       segment_.a.y + to * (segment_.b.y - segment_.a.y)};
      const Side at_here = sides_.at(to);
      insert(from, to, at_from, at_here, passes - 1);
      target_.points.push_back(here);
      target_.labels.push_back(at_here);
      from = to;
      at_from = at_here;
    }
    insert(from, high, at_from, at_high, passes - 1);
  }

 private:
  const Segment& segment_;
  SegmentSides sides_;
  int points_;
  PointBudget& budget_;
  LabelledCurve& target_;
};

}  // namespace

LabelledCurve insert_points(const CurveView& curve, const Buffer<Side>& labels, std::span<const SideChange> changes,
                            int passes, int points, std::size_t max_points) {
  const std::size_t size = curve.points.size();
  PointBudget budget(max_points);
  budget.take(size);
  std::vector<LabelledCurve> blocks((size + insertions_a_block - 1) / insertions_a_block);
  for_each_block(size, insertions_a_block, [&](std::size_t begin, std::size_t end) {
    LabelledCurve& block = blocks[begin / insertions_a_block];
    block.points.reserve(end - begin);
    block.labels.reserve(end - begin);
    const auto first_from = [&](std::size_t segment) {
      return std::partition_point(changes.begin(), changes.end(),
                                  [&](const SideChange& change) { return change.at.segment < segment; });
    };
    auto next = first_from(begin);
    for (std::size_t k = begin; k < end; ++k) {
      block.points.push_back(curve.points[k]);
      block.labels.push_back(labels[k]);
      const auto first = next;
      while (next != changes.end() && next->at.segment == k) ++next;
      const Side at_end = labels[k + 1 == size ? 0 : k + 1];
      if (points <= 0 || labels[k] == at_end) continue;
      const SegmentSides sides{first == changes.begin() ? changes.back().side : std::prev(first)->side, {first, next}};
      Inserter(curve.segment(k), sides, points, budget, block).insert(0, 1, labels[k], at_end, passes);
    }
  });
  LabelledCurve result;
  for (LabelledCurve& block : blocks) {
    result.points.insert(result.points.end(), block.points.begin(), block.points.end());
    result.labels.insert(result.labels.end(), block.labels.begin(), block.labels.end());
    block = {};
  }
  return result;
}

}  // namespace lober::detail
