// Pairs of segments from a uniform grid over the segments of the second curve.
//
// The grid covers only what the boxes of the two curves have in common. Segments are entered cell by cell
// along their line, not by their box, so that long slanted ones stay cheap: that is what the grid is for.

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "engine/geometry/index/block_search.hpp"
#include "engine/geometry/index/raster.hpp"
#include "engine/geometry/index/search.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t raster_leaves_sampled = 2048;
constexpr std::size_t leaves_per_task = 512;
constexpr std::size_t cells_per_task = 1 << 14;

// The segments of each cell, in one array, cell by cell, ascending within a cell.
class Grid {
 public:
  Grid(const IndexedCurve& curve, const Box& window, std::uint64_t max_entries)
      : curve_(curve),
        max_entries_(max_entries),
        raster_(Raster::fitted(curve.tree(), window, max_entries, raster_leaves_sampled)) {
    while (!count()) raster_ = raster_.coarser();
    enter();
    sort_cells();
  }

  // Looks up segments one after the other. Remembers in a bit per segment of the curve which ones it has met.
  class Finder {
   public:
    explicit Finder(const Grid& grid) : grid_(grid), met_bits_(grid.met_bits_.local()) {
      met_bits_.resize((grid.curve_.segments() + 63) / 64, 0);
    }

    // Appends the segments whose boxes meet `box` from the cells of a segment; returns the entries looked at.
    std::size_t operator()(const Segment& ends, const Box& box, Buffer<std::uint32_t>& candidates) {
      std::size_t looked_at = 0;
      grid_.raster_.for_each_cell(ends.a, ends.b, [&](std::size_t cell) {
        const std::uint32_t begin = cell == 0 ? 0 : grid_.end_[cell - 1], end = grid_.end_[cell];
        looked_at += end - begin + 1;
        for (std::uint32_t k = begin; k < end; ++k) meet_once(grid_.entries_[k]);
      });
      for (const std::uint32_t segment : met_) {
        met_bits_[segment / 64] = 0;
        const Segment other = grid_.curve_.view().segment(segment);
        if (meet(box, Box::of(other.a, other.b))) candidates.push_back(segment);
      }
      met_.clear();
      return looked_at;
    }

   private:
    void meet_once(std::uint32_t segment) {
      const std::uint64_t bit = std::uint64_t{1} << segment % 64;
      if ((met_bits_[segment / 64] & bit) != 0) return;
      met_bits_[segment / 64] |= bit;
      met_.push_back(segment);
    }

    const Grid& grid_;
    std::vector<std::uint64_t>& met_bits_;
    Buffer<std::uint32_t> met_;
  };

 private:
  // Calls visit(segment, cell) for every entry and done(entries) after each leaf, until that returns false.
  template <typename Visit, typename Done>
  void for_each_entry(const Visit& visit, const Done& done) const {
    const BoxTree& tree = curve_.tree();
    for_each_block(tree.leaves(), leaves_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t leaf = begin; leaf < end; ++leaf) {
        std::uint64_t entries = 0;
        for_each_segment_of_leaf(tree, leaf, raster_.window(), [&](std::uint32_t segment, const Segment& ends) {
          raster_.for_each_cell(ends.a, ends.b, [&](std::size_t cell) {
            ++entries;
            visit(segment, cell);
          });
        });
        if (!done(entries)) return;
      }
    });
  }

  // Counts the entries of each cell into end_. Gives up and returns false when there are too many.
  bool count() {
    end_.resize(raster_.cells());
    for_each_block(end_.size(), cells_per_task,
                   [&](std::size_t begin, std::size_t end) { std::fill(end_.data() + begin, end_.data() + end, 0); });
    std::atomic<std::uint64_t> total = 0;
    for_each_entry(
        [&](std::uint32_t, std::size_t cell) { std::atomic_ref(end_[cell]).fetch_add(1, std::memory_order_relaxed); },
        [&](std::uint64_t entries) {
          return total.fetch_add(entries, std::memory_order_relaxed) + entries <= max_entries_;
        });
    return total <= max_entries_;
  }

  // Turns the counts into the beginnings of the cells; entering the segments moves each on to the end of its
  // cell.
  void enter() {
    std::uint32_t total = 0;
    for (std::uint32_t& begin : end_) {
      const std::uint32_t size = begin;
      begin = total;
      total += size;
    }
    entries_.resize(total);
    for_each_entry(
        [&](std::uint32_t segment, std::size_t cell) {
          entries_[std::atomic_ref(end_[cell]).fetch_add(1, std::memory_order_relaxed)] = segment;
        },
        [](std::uint64_t) { return true; });
  }

  // Threads enter segments in any order; sorting makes the output independent of it.
  void sort_cells() {
    for_each_block(end_.size(), cells_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t cell = begin; cell < end; ++cell) {
        std::sort(entries_.data() + (cell == 0 ? 0 : end_[cell - 1]), entries_.data() + end_[cell]);
      }
    });
  }

  const IndexedCurve& curve_;
  std::uint64_t max_entries_;
  Raster raster_;
  Buffer<std::uint32_t> end_;
  Buffer<std::uint32_t> entries_;
  mutable tbb::enumerable_thread_specific<std::vector<std::uint64_t>> met_bits_;  // all zero between two look-ups
};

}  // namespace

SearchCounts find_pairs_by_grid(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer) {
  const Box& box = second.tree().box();
  if (!meet(first.tree().box(), box)) return search_nothing(first.tree());
  const Box window = intersection(first.tree().box(), box);
  const Grid grid(second, window, max_grid_entries(first.segments() + second.segments()));
  return search_blocks(first.tree(), window, consumer, [&] { return Grid::Finder(grid); });
}

}  // namespace lober::detail
