#include "engine/batch/work_queue.hpp"

#include <algorithm>
#include <tuple>

#include "engine/batch/queue/z_order.hpp"

namespace lober::detail {
namespace {

// Microseconds of work in a portion. With fewer the process that hands them out could not keep all others busy: a
// portion costs it about a millisecond. With more, a process that dies takes much along.
constexpr double min_cost = 2'000, min_cost_per_process = 1'000, max_cost = 20'000'000;
constexpr double long_cost = 50'000;  // a job with more comes before all others, so that nobody waits for it in the end
constexpr std::size_t max_jobs = 50'000;  // some 20 MB of results

std::uint64_t position_of(const Job& job) {
  return z_order(job.first, job.second == no_curve ? job.first : job.second);
}

}  // namespace

WorkQueue::WorkQueue(const Plan& plan, const std::string& manifest_path, std::span<const std::uint32_t> jobs) {
  const std::vector<std::size_t> points = estimated_points(plan, manifest_path);
  struct Turn {
    bool is_short;
    std::uint64_t position;
    Entry entry;
    auto key() const { return std::tie(is_short, position, entry.job); }
  };
  std::vector<Turn> turns;
  turns.reserve(jobs.size());
  for (const std::uint32_t number : jobs) {
    const Job& job = plan.jobs[number];
    std::size_t together = 0;
    for (const CurveId id : job.curves()) together += points[id];
    const double cost = plan.group_of(job).operation->cost(together);
    left_ += cost;
    turns.push_back({cost < long_cost, position_of(job), {cost, number}});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.key() < b.key(); });
  jobs_.reserve(turns.size());
  for (const Turn& turn : turns) jobs_.push_back(turn.entry);
}

std::vector<std::uint32_t> WorkQueue::next_portion(std::size_t processes) {
  const auto workers = static_cast<double>(processes);
  const double share = std::clamp(left_ / (4 * workers), std::max(min_cost, workers * min_cost_per_process), max_cost);
  std::vector<std::uint32_t> portion;
  for (double dealt = 0; next_ < jobs_.size() && portion.size() < max_jobs; ++next_) {
    const auto& [cost, job] = jobs_[next_];
    if (!portion.empty() && dealt + cost > share) break;
    portion.push_back(job);
    dealt += cost;
    left_ -= cost;
  }
  return portion;
}

}  // namespace lober::detail
