#include "engine/batch/queue/schedule.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

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

}  // namespace

std::vector<std::uint32_t> schedule(std::span<const ScheduledJob> jobs, std::span<const std::size_t> unit_bytes,
                                    const MemoryBudget& budget) {
  const Grouping groups = group(jobs, unit_bytes, budget);
  double total = 0;
  for (const ScheduledJob& job : jobs) total += job.cost;
  struct Turn {
    std::uint32_t block;
    std::uint32_t passing;  // 0: both units are in the block; else the rank of the later one, from 1
    double minus_cost;      // 0: short
    std::uint64_t position;
    std::uint32_t job;
    auto key() const { return std::tie(block, passing, minus_cost, position, job); }
  };
  std::vector<Turn> turns(jobs.size());
  for (std::uint32_t k = 0; k < jobs.size(); ++k) {
    std::uint32_t early = jobs[k].unit1, late = jobs[k].unit2;
    if (early == ScheduledJob::nothing) {
      turns[k] = {0, 0, -jobs[k].cost, 0, k};
      continue;
    }
    if (groups.rank[late] < groups.rank[early]) std::swap(early, late);
    const bool inside = groups.block[early] == groups.block[late], is_short = jobs[k].cost < short_part * total;
    turns[k] = {groups.block[early], inside ? 0 : groups.rank[late] + 1, is_short ? 0 : -jobs[k].cost,
                is_short ? z_order(groups.rank[early], groups.rank[late]) : 0, k};
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.key() < b.key(); });
  std::vector<std::uint32_t> order(jobs.size());
  std::transform(turns.begin(), turns.end(), order.begin(), [](const Turn& turn) { return turn.job; });
  return order;
}

}  // namespace lober::detail
