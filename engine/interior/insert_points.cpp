#include "engine/interior/insert_points.hpp"

#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = 4096;

class Inserter {
 public:
  Inserter(const Segment& segment, const IndexedCurve& other, int points, LabelledCurve& target)
      : segment_(segment), other_(other), points_(points), target_(target) {}

  // Appends what belongs strictly between parameters low and high, where the labels are as given.
  void insert(double low, double high, Side at_low, Side at_high, int passes) {
    const double step = (high - low) / (points_ + 1.0);
    constexpr double finest = 0x1p-52;  // beyond, neighbours would be the same point
    if (at_low == at_high || passes == 0 || step < finest) return;
    double from = low;
    Side at_from = at_low;
    for (int k = 1; k <= points_; ++k) {
      const double to = low + k * step;
      const Point here{segment_.a.x + to * (segment_.b.x - segment_.a.x),
                       segment_.a.y + to * (segment_.b.y - segment_.a.y)};
      const Side at_here = side_of(other_, here);
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
  const IndexedCurve& other_;
  int points_;
  LabelledCurve& target_;
};

}  // namespace

LabelledCurve insert_points(const CurveView& curve, const Buffer<Side>& labels, const IndexedCurve& other, int passes,
                            int points) {
  const std::size_t size = curve.points.size();
  std::vector<LabelledCurve> blocks((size + grain - 1) / grain);
  for_each_block(size, grain, [&](std::size_t begin, std::size_t end) {
    LabelledCurve& block = blocks[begin / grain];
    block.points.reserve(end - begin);
    block.labels.reserve(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      block.points.push_back(curve.points[k]);
      block.labels.push_back(labels[k]);
      const Segment segment = curve.segment(k);
      const Side at_end = labels[k + 1 == size ? 0 : k + 1];
      if (points > 0) Inserter(segment, other, points, block).insert(0, 1, labels[k], at_end, passes);
    }
  });
  LabelledCurve result;
  for (const LabelledCurve& block : blocks) {
    result.points.insert(result.points.end(), block.points.begin(), block.points.end());
    result.labels.insert(result.labels.end(), block.labels.begin(), block.labels.end());
  }
  return result;
}

}  // namespace lober
