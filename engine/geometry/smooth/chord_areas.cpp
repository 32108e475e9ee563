#include "engine/geometry/smooth/chord_areas.hpp"

#include <algorithm>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t segments_a_block = 2048, segments_an_entry = 16;

class Running {
 public:
  explicit Running(const ChordArea& start = {}) : error_(start.error) { area_.add(start.area); }
  void add(double area, double error) {
    area_.add({area, 0});
    error_ += error;
  }
  [[nodiscard]] ChordArea value() const { return {area_.value(), error_}; }

 private:
  RunningSum area_;
  double error_;
};

}  // namespace

ChordAreaTable::ChordAreaTable(const SmoothCurve& curve) {
  const std::size_t size = curve.segments(), blocks = (size + segments_a_block - 1) / segments_a_block;
  before_.resize(size / segments_an_entry + 1);  // a position may be the end of an open curve
  std::vector<ChordArea> totals(blocks + 1);
  std::vector<std::uint64_t> fallbacks(blocks);
  for_each_block(size, segments_a_block, [&](std::size_t begin, std::size_t end) {
    Running sum;
    SmoothCurve::Few few;
    for (std::size_t first = begin; first < end; first += SmoothCurve::Few::most) {
      const std::size_t last = std::min(first + SmoothCurve::Few::most, end);
      curve.fit(first, last, few);
      fallbacks[begin / segments_a_block] += few.straight;
      for (std::size_t k = first; k < last; ++k) {
        if (k % segments_an_entry == 0) before_[k / segments_an_entry] = sum.value();
        sum.add(few.areas[k - first], few.errors[k - first]);
      }
    }
    totals[begin / segments_a_block + 1] = sum.value();
  });
  for (std::size_t block = 0; block < blocks; ++block) {
    totals[block + 1].area += totals[block].area;
    totals[block + 1].error += totals[block].error;
    fallbacks_ += fallbacks[block];
  }
  total_ = totals[blocks];
  for (std::size_t entry = 0; entry * segments_an_entry < size; ++entry) {
    const ChordArea& block = totals[entry * segments_an_entry / segments_a_block];
    before_[entry].area += block.area;
    before_[entry].error += block.error;
  }
  if (size % segments_an_entry == 0) before_[size / segments_an_entry] = total_;
}

Buffer<ChordArea> ChordAreaTable::before(const SmoothCurve& curve, std::span<const std::uint32_t> segments) const {
  Buffer<ChordArea> sums(segments.size());
  for_each_block(segments.size(), 512, [&](std::size_t begin, std::size_t end) {
    Running sum;
    SmoothCurve::Few few;
    std::size_t next = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t entry = segments[k] / segments_an_entry;
      if (k == begin || next < entry * segments_an_entry) {
        sum = Running(before_[entry]);
        next = entry * segments_an_entry;
      }
      if (next < segments[k]) {  // fewer than an entry has
        curve.fit(next, segments[k], few);
        for (std::size_t first = next; next < segments[k]; ++next)
          sum.add(few.areas[next - first], few.errors[next - first]);
      }
      sums[k] = sum.value();
    }
  });
  return sums;
}

}  // namespace lober::detail
