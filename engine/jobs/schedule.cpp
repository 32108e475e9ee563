#include "engine/jobs/schedule.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lober {
namespace {

// The block of each unit that is used, numbered in order of first use; 0 for all if everything fits.
std::vector<std::uint32_t> blocks_of(std::span<const ScheduledJob> jobs, std::span<const std::size_t> bytes,
                                     std::size_t budget) {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> block(bytes.size(), unused);
  std::vector<std::uint32_t> order;
  std::size_t total = 0;
  for (const ScheduledJob& job : jobs) {
    for (const std::uint32_t unit : {job.unit1, job.unit2}) {
      if (block[unit] != unused) continue;
      block[unit] = 0;
      order.push_back(unit);
      total += bytes[unit];
    }
  }
  const std::size_t for_curves = budget / 10 * 8;  // the rest for what running jobs take
  if (total <= for_curves) return block;
  std::uint32_t number = 0;
  std::size_t filled = 0;
  for (const std::uint32_t unit : order) {
    if (filled != 0 && filled + bytes[unit] > for_curves / 2) {
      ++number;
      filled = 0;
    }
    filled += bytes[unit];
    block[unit] = number;
  }
  return block;
}

}  // namespace

std::vector<std::uint32_t> schedule(std::span<const ScheduledJob> jobs, std::span<const std::size_t> unit_bytes,
                                    std::size_t budget) {
  const std::vector<std::uint32_t> block = blocks_of(jobs, unit_bytes, budget);
  struct Place {
    std::uint32_t row;
    std::int64_t column;
    double minus_cost;
    std::uint32_t job;
    auto key() const { return std::tie(row, column, minus_cost, job); }
  };
  std::vector<Place> places(jobs.size());
  for (std::uint32_t k = 0; k < jobs.size(); ++k) {
    const auto [low, high] = std::minmax({block[jobs[k].unit1], block[jobs[k].unit2]});
    const std::int64_t column = low % 2 == 0 ? high : -static_cast<std::int64_t>(high);
    places[k] = {low, column, -jobs[k].cost, k};
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.key() < b.key(); });
  std::vector<std::uint32_t> order(jobs.size());
  std::transform(places.begin(), places.end(), order.begin(), [](const Place& place) { return place.job; });
  return order;
}

}  // namespace lober
