// In which order jobs start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lober {

struct ScheduledJob {
  std::uint32_t unit1 = 0, unit2 = 0;  ///< what it reads; equal if it reads only one
  double cost = 0;
};

/// If everything fits into `budget` bytes, by falling cost, so that what starts last is short. If not, units are put
/// into blocks, of which two fit at once, and pairs of blocks are gone through like the rows of a field, back and
/// forth: each step keeps one of the two blocks. Inside a pair of blocks by falling cost. Equal costs in the order
/// given. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> schedule(std::span<const ScheduledJob> jobs,
                                                  std::span<const std::size_t> unit_bytes, std::size_t budget);

}  // namespace lober
