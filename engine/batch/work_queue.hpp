// Hands out jobs to processes: large portions first, small ones towards the end, so that all finish together.
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
  /// `jobs` of the plan, to be handed out to `processes` processes. Costs are estimated from the sizes of the files.
  WorkQueue(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
            std::size_t processes);

  /// The next portion: a share of the rest, by cost; empty when nothing is left.
  [[nodiscard]] std::vector<std::uint32_t> next_portion();

 private:
  std::vector<std::uint32_t> jobs_;  ///< by falling cost
  std::vector<double> costs_;
  double left_ = 0;
  std::size_t next_ = 0, processes_;
};

}  // namespace lober::detail
