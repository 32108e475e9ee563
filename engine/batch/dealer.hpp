// Hands out jobs to processes: large portions first, small ones towards the end, so that all finish together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/batch/plan.hpp"

namespace lober {

class Dealer {
 public:
  /// `jobs` of the plan, to be dealt to so many processes. Costs are estimated from the sizes of the files.
  Dealer(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs,
         std::size_t processes);

  /// The next portion: a share of what is left, by cost; empty when nothing is left.
  [[nodiscard]] std::vector<std::uint32_t> deal();

 private:
  std::vector<std::uint32_t> jobs_;  ///< by falling cost
  std::vector<double> costs_;
  double left_ = 0;
  std::size_t next_ = 0, processes_;
};

}  // namespace lober
