#include "engine/geometry/crossings/common_runs.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lober::detail {

void CommonRuns::merge() {
  if (runs_.empty()) return;
  std::sort(runs_.begin(), runs_.end(), [](const CommonRun& x, const CommonRun& y) { return x.first < y.first; });
  std::vector<CommonRun> merged;
  for (const CommonRun& run : runs_) {
    if (!merged.empty() && run.first < merged.back().last) {
      merged.back().last = std::max(merged.back().last, run.last);
    } else {
      merged.push_back(run);
    }
  }
  runs_ = std::move(merged);
}

bool CommonRuns::has_inside(std::uint32_t segment) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), segment,
                                      [](std::uint32_t value, const CommonRun& run) { return value <= run.first; });
  return after != runs_.begin() && segment < std::prev(after)->last;
}

}  // namespace lober::detail
