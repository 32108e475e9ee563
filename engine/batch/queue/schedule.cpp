#include "engine/batch/queue/schedule.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/base/parallel/counting_sort.hpp"
#include "engine/batch/queue/z_order.hpp"

namespace lober::detail {
namespace {

// A job that costs less than that part of all is short: it does not matter when it ends.
constexpr double short_part = 1.0 / 4096;

struct Grouping {
  std::vector<std::uint32_t> rank;   ///< rank of each unit, in order of first use
  std::vector<std::uint32_t> block;  ///< block of each unit; 0 for all if everything fits
};

Grouping group(std::span<const ScheduledJob> jobs, std::span<const std::size_t> bytes, const MemoryBudget& budget) {
  constexpr std::uint32_t unused = 0xffffffff;
  Grouping groups{std::vector<std::uint32_t>(bytes.size(), unused), std::vector<std::uint32_t>(bytes.size(), 0)};
  std::vector<std::uint32_t> order;
  std::size_t total = 0;
  for (const ScheduledJob& job : jobs) {
    for (const std::uint32_t unit : {job.unit1, job.unit2}) {
      if (unit == ScheduledJob::nothing || groups.rank[unit] != unused) continue;
      groups.rank[unit] = static_cast<std::uint32_t>(order.size());
      order.push_back(unit);
      total += bytes[unit];
    }
  }
  if (total <= budget.all) return groups;
  std::uint32_t number = 0;
  std::size_t filled = 0;
  for (const std::uint32_t unit : order) {
    if (filled != 0 && filled + bytes[unit] > budget.block) {
      ++number;
      filled = 0;
    }
    filled += bytes[unit];
    groups.block[unit] = number;
  }
  return groups;
}

// The numbers of the jobs, sorted stably by one key after the other. A key that is 0 for all takes no time.
class Order {
 public:
  explicit Order(std::size_t count) : jobs_(count) { std::iota(jobs_.begin(), jobs_.end(), 0U); }

  template <typename KeyOf>
  void sort_by(const KeyOf& key_of) {
    std::uint32_t largest = 0;
    for (const std::uint32_t job : jobs_) largest = std::max(largest, key_of(job));
    if (largest == 0) return;
    const Buffer<KeyedNumber> sorted =
        sorted_by_key(jobs_.size(), largest, [&](std::size_t k) { return key_of(jobs_[k]); });
    std::vector<std::uint32_t> next(jobs_.size());
    for (std::size_t k = 0; k < next.size(); ++k) next[k] = jobs_[sorted[k].number];
    jobs_.swap(next);
  }
  template <typename KeyOf>
  void sort_by_number(const KeyOf& key_of) {
    if (std::all_of(jobs_.begin(), jobs_.end(), [&](std::uint32_t job) { return key_of(job) == 0; })) return;
    std::stable_sort(jobs_.begin(), jobs_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return key_of(a) < key_of(b); });
  }
  [[nodiscard]] std::vector<std::uint32_t> jobs() && { return std::move(jobs_); }

 private:
  std::vector<std::uint32_t> jobs_;
};

}  // namespace

std::vector<std::uint32_t> schedule(std::span<const ScheduledJob> jobs, std::span<const std::size_t> unit_bytes,
                                    const MemoryBudget& budget) {
  const Grouping groups = group(jobs, unit_bytes, budget);
  double total = 0;
  for (const ScheduledJob& job : jobs) total += job.cost;
  struct Turn {
    std::uint32_t block = 0;
    std::uint32_t passing = 0;   // 0: both units are in the block; else the rank of the later one, from 1
    double minus_cost = 0;       // 0: short
    std::uint64_t position = 0;  // if it is short
  };
  std::vector<Turn> turns(jobs.size());
  for (std::uint32_t k = 0; k < jobs.size(); ++k) {
    std::uint32_t early = jobs[k].unit1, late = jobs[k].unit2;
    if (early == ScheduledJob::nothing) {
      turns[k].minus_cost = -jobs[k].cost;
      continue;
    }
    if (groups.rank[late] < groups.rank[early]) std::swap(early, late);
    const bool inside = groups.block[early] == groups.block[late], is_short = jobs[k].cost < short_part * total;
    turns[k] = {groups.block[early], inside ? 0 : groups.rank[late] + 1, is_short ? 0 : -jobs[k].cost,
                is_short ? z_order(groups.rank[early], groups.rank[late]) : 0};
  }
  // By block, then passing, cost and position, last by number: stably, the last of these first. Mostly all jobs are
  // short and in one block.
  Order order(jobs.size());
  order.sort_by([&](std::uint32_t job) { return static_cast<std::uint32_t>(turns[job].position); });
  order.sort_by([&](std::uint32_t job) { return static_cast<std::uint32_t>(turns[job].position >> 32); });
  order.sort_by_number([&](std::uint32_t job) { return turns[job].minus_cost; });
  order.sort_by([&](std::uint32_t job) { return turns[job].passing; });
  order.sort_by([&](std::uint32_t job) { return turns[job].block; });
  return std::move(order).jobs();
}

}  // namespace lober::detail
