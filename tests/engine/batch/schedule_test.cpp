#include "engine/batch/queue/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <list>

namespace lober::detail {
namespace {

// How often units are read when jobs go one by one through a cache of `bytes` bytes that drops the least recently used.
std::size_t readings(std::span<const ScheduledJob> jobs, std::span<const std::uint32_t> order, std::size_t unit_bytes,
                     std::size_t budget) {
  std::list<std::uint32_t> cache;
  std::size_t count = 0;
  for (const std::uint32_t job : order) {
    for (const std::uint32_t unit : {jobs[job].unit1, jobs[job].unit2}) {
      const auto at = std::find(cache.begin(), cache.end(), unit);
      if (at == cache.end()) ++count;
      if (at != cache.end()) cache.erase(at);
      cache.push_front(unit);
      if (cache.size() * unit_bytes > budget) cache.pop_back();
    }
  }
  return count;
}

std::vector<ScheduledJob> all_pairs(std::uint32_t units) {
  std::vector<ScheduledJob> jobs;
  for (std::uint32_t i = 0; i < units; ++i) {
    for (std::uint32_t k = i + 1; k < units; ++k) jobs.push_back({i, k, 1});
  }
  return jobs;
}

TEST(Schedule, WhatFitsGoesByFallingCost) {
  const std::vector<ScheduledJob> jobs{{0, 1, 1}, {1, 2, 5}, {0, 2, 3}, {2, 2, 5}};
  EXPECT_EQ(schedule(jobs, std::vector<std::size_t>{10, 10, 10}, {1000, 0}), (std::vector<std::uint32_t>{1, 3, 2, 0}));
}

TEST(Schedule, EachJobComesOnce) {
  const std::vector<ScheduledJob> jobs = all_pairs(30);
  std::vector<std::uint32_t> order = schedule(jobs, std::vector<std::size_t>(30, 100), {1000, 700});
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), jobs.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) EXPECT_EQ(order[k], k);
}

TEST(Schedule, WhatDoesNotFitIsReadFewTimes) {
  const std::vector<ScheduledJob> jobs = all_pairs(100);
  const std::vector<std::size_t> bytes(100, 100);
  std::vector<std::uint32_t> plain(jobs.size());
  for (std::uint32_t k = 0; k < plain.size(); ++k) plain[k] = k;
  const std::size_t tiled = readings(jobs, schedule(jobs, bytes, {2000, 1500}), 100, 2500);
  // Blocks of fifteen: each is read, and all that come later pass by.
  EXPECT_LE(tiled, 100 + 85 + 70 + 55 + 40 + 25 + 10);
  EXPECT_LT(4 * tiled, readings(jobs, plain, 100, 2500));
}

}  // namespace
}  // namespace lober::detail
