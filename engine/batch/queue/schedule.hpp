// The order in which jobs start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lober::detail {

/// A job of a queue as scheduling sees it.
struct ScheduledJob {
  static constexpr std::uint32_t nothing = 0xffffffff;
  std::uint32_t unit1 = nothing, unit2 = nothing;  ///< the units it reads; equal if it reads only one or nothing
  double cost = 0;
  std::uint32_t number = 0;       ///< in the queue
  std::size_t working_bytes = 0;  ///< that it takes besides its curves
};

/// Bytes for units.
struct MemoryBudget {
  std::size_t all;    ///< if nothing has to be read again
  std::size_t block;  ///< besides those that pass by
};

/// If everything fits, by falling cost, so that what starts last is short. If not, units are put into
/// blocks: first the jobs inside the first block by falling cost, then, unit after unit,
/// those of its units with the later ones, which pass by while the block stays; then the same with the next block. A
/// unit is read about once for each block before its own. Equal costs in the order given, except for jobs that cost
/// little beside all the others together: these come last, on a Z-order curve through the pairs of units, so that the
/// units they read stay in the processor's caches. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> schedule(std::span<const ScheduledJob> jobs,
                                                  std::span<const std::size_t> unit_bytes, const MemoryBudget& budget);

}  // namespace lober::detail
