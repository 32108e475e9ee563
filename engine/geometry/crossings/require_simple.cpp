// A curve against itself.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/geometry/crossings/require_simple.hpp"
#include "engine/geometry/crossings/rotation.hpp"
#include "engine/geometry/curve/point_along.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "kernels/pair_filter.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober {
using namespace detail;
namespace {

class SelfChecker final : public PairConsumer {
 public:
  /// Keeps the first pair that meets, and up to `most` others.
  explicit SelfChecker(const CurveView& curve, std::size_t most = 0)
      : curve_(curve),
        most_(most),
        source_{curve.points.data(), static_cast<std::uint32_t>(curve.points.size() - 1)},
        blocks_((curve.segments() + block_segments - 1) / block_segments) {}

  std::uint32_t consume(std::uint32_t number, std::span<const SegmentPair> pairs) override {
    constexpr std::uint32_t to_the_end = std::numeric_limits<std::uint32_t>::max();
    Block& block = blocks_[number];
    block.pairs += pairs.size();
    block.verdicts.resize(std::max(pairs.size(), block.verdicts.size()));
    filter_pairs(source_, source_, pairs.data(), pairs.size(), block.verdicts.data());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const SegmentPair& pair = pairs[k];
      if (block.verdicts[k] == PairVerdict::apart) continue;
      const bool wanted = block.meetings.size() < most_;
      if (block.first_bad < pair && !wanted) continue;
      if (block.verdicts[k] == PairVerdict::uncertain && !bad(pair, block.counts)) continue;
      block.first_bad = std::min(block.first_bad, pair);
      if (wanted) block.meetings.push_back(pair);
    }
    // Leaves come in order: what follows has no earlier pair. A curve that lies across itself everywhere has as many as
    // it has pairs of segments.
    if (most_ > 0 || block.first_bad == none) return 0;
    std::uint32_t known = first_bad_block_.load(std::memory_order_relaxed);
    while (number < known && !first_bad_block_.compare_exchange_weak(known, number, std::memory_order_relaxed)) {
    }
    return to_the_end;
  }
  [[nodiscard]] bool wants(std::uint32_t number) const override {
    return number <= first_bad_block_.load(std::memory_order_relaxed);
  }
  void finish(std::uint32_t number) override { blocks_[number].verdicts = {}; }

  [[nodiscard]] SegmentPair first_bad() const {
    SegmentPair first = none;
    for (const Block& block : blocks_) first = std::min(first, block.first_bad);
    return first;
  }
  [[nodiscard]] std::vector<SegmentPair> meetings() const {
    std::vector<SegmentPair> list;
    for (const Block& block : blocks_) list.insert(list.end(), block.meetings.begin(), block.meetings.end());
    std::sort(list.begin(), list.end());
    list.resize(std::min(list.size(), most_));
    return list;
  }
  [[nodiscard]] std::uint64_t pairs() const {
    std::uint64_t sum = 0;
    for (const Block& block : blocks_) sum += block.pairs;
    return sum;
  }
  static constexpr SegmentPair none{std::numeric_limits<std::uint32_t>::max(),
                                    std::numeric_limits<std::uint32_t>::max()};

 private:
  struct Block {
    SegmentPair first_bad = none;
    std::uint64_t pairs = 0;
    PredicateCounts counts;
    Buffer<PairVerdict> verdicts;
    std::vector<SegmentPair> meetings;
  };

  // Whether the two segments meet where they should not.
  bool bad(const SegmentPair& pair, PredicateCounts& counts) const {
    const auto [a, b] = curve_.segment(pair.first);
    const auto [c, d] = curve_.segment(pair.second);
    if (a == b || c == d) return false;  // repeated vertices carry no segment
    // Most pairs that come here are neighbours: with d off the line through a and b they share b alone.
    if (pair.second == pair.first + 1 && orient2d(a, b, d, counts) != 0) return false;
    const int side_c = orient2d(a, b, c, counts), side_d = orient2d(a, b, d, counts);
    if (side_c * side_d > 0) return false;
    const int side_a = orient2d(c, d, a, counts), side_b = orient2d(c, d, b, counts);
    if (side_a * side_b > 0) return false;
    if (side_a * side_b < 0 && side_c * side_d < 0) return true;
    // Neighbours may share their common vertex and nothing else.
    const bool second_follows = leads_to(pair.first, pair.second), first_follows = leads_to(pair.second, pair.first);
    const auto only_common = [&](bool follows, Point shared, Point other_shared) {
      return follows && shared == other_shared;
    };
    const bool b_excused = only_common(second_follows, b, c), a_excused = only_common(first_follows, a, d);
    const auto meets = [&](int side, Point from, Point to, Point p, bool excused) {
      return side == 0 && !excused && on_segment(from, to, p, counts);
    };
    return meets(side_a, c, d, a, a_excused) || meets(side_b, c, d, b, b_excused) ||
           meets(side_c, a, b, c, b_excused) || meets(side_d, a, b, d, a_excused);
  }

  // Whether `next` is the segment after `segment`, repeated vertices aside.
  bool leads_to(std::uint32_t number, std::uint32_t next) const {
    const auto size = static_cast<std::uint32_t>(curve_.points.size());
    std::uint32_t vertex = number + 1 == size ? 0 : number + 1;
    while (vertex != next) {
      const std::uint32_t after = vertex + 1 == size ? 0 : vertex + 1;
      if (after == 0 && !curve_.closed) return false;
      if (!(curve_.points[after] == curve_.points[vertex])) return false;
      vertex = after;
    }
    return true;
  }

  CurveView curve_;
  std::size_t most_;
  SegmentSource source_;
  std::vector<Block> blocks_;
  std::atomic<std::uint32_t> first_bad_block_{std::numeric_limits<std::uint32_t>::max()};  // whose pairs are wanted
};

// A point where two segments that meet do so.
Point common_point(const Segment& first, const Segment& second) {
  PredicateCounts counts;
  for (const Point p : {second.a, second.b}) {
    if (on_segment(first.a, first.b, p, counts)) return p;
  }
  for (const Point p : {first.a, first.b}) {
    if (on_segment(second.a, second.b, p, counts)) return p;
  }
  return point_along(first, exact_parameter(first.a, first.b, {second.a, second.b}));
}

}  // namespace

SelfMeetings self_meetings(const IndexedCurve& curve, std::size_t most) {
  SelfChecker checker(curve.view(), most);
  SelfMeetings found;
  found.check.search = find_self_pairs(curve, checker);
  found.check.pairs = checker.pairs();
  found.pairs = checker.meetings();
  return found;
}

SimpleCheck detail::require_simple_scaled(const IndexedCurve& curve, int number, int exponent) {
  SelfChecker checker(curve.view());
  SimpleCheck result;
  result.search = find_self_pairs(curve, checker);
  result.pairs = checker.pairs();
  const SegmentPair bad = checker.first_bad();
  if (bad == SelfChecker::none) return result;
  const Point at = common_point(curve.view().segment(bad.first), curve.view().segment(bad.second));
  throw NotSimpleError(number, bad.first, bad.second, {std::ldexp(at.x, -exponent), std::ldexp(at.y, -exponent)});
}

SimpleCheck require_simple(const IndexedCurve& curve, int number) {
  const int exponent = scaling_exponent(curve.tree().box());
  if (exponent == 0) return require_simple_scaled(curve, number, 0);
  const std::vector<Point> points = scaled(curve.view(), exponent);
  return require_simple_scaled(IndexedCurve(CurveView{points, curve.view().closed}), number, exponent);
}

}  // namespace lober
