// Hands out jobs to processes: portions whose jobs share their curves, large ones first and small ones towards the end,
// so that all processes finish together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/batch/manifest/plan.hpp"

namespace lober::detail {

class WorkQueue {
 public:
  /// `jobs` of the plan. Costs are estimated from the sizes of the files. The jobs of a portion of n pairs have
  /// O(sqrt(n)) curves where all pairs are asked for: they follow each other on a Z-order curve through the pairs.
  /// O(n log n), 24 bytes a job.
  WorkQueue(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs);

  /// The next portion for one of `processes` processes, at least 1 of them: a share of the rest, by cost; empty when
  /// nothing is left.
  [[nodiscard]] std::vector<std::uint32_t> next_portion(std::size_t processes);

 private:
  struct Entry {
    double cost;  ///< microseconds of one core
    std::uint32_t job;
  };
  std::vector<Entry> jobs_;
  double left_ = 0;
  std::size_t next_ = 0;
};

}  // namespace lober::detail
