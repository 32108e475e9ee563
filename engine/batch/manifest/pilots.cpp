#include "engine/batch/manifest/pilots.hpp"

#include <algorithm>
#include <exception>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/processor_time.hpp"
#include "engine/base/time_limit.hpp"
#include "engine/batch/operations/operation.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t max_pilots = 9;

// The ends first, then the middle, then the middles of what is between.
std::vector<std::size_t> spread_over(std::size_t count) {
  const std::size_t wanted = std::min(count, max_pilots);
  std::vector<std::size_t> chosen;
  const auto choose = [&](std::size_t k) {
    if (std::find(chosen.begin(), chosen.end(), k) == chosen.end()) chosen.push_back(k);
  };
  if (count == 0) return chosen;
  choose(0);
  for (std::size_t parts = 1; chosen.size() < wanted; parts *= 2) {
    for (std::size_t k = 1; k <= parts && chosen.size() < wanted; ++k) choose(k * (count - 1) / parts);
  }
  return chosen;
}

struct Flight {
  double seconds = 0;   // time of the pilot
  double forecast = 0;  // time of the job that it stands for
};

Flight flown(const Operation& operation, const Options& options, const Stopwatch& watch, double broken_off_after) {
  const Pilot pilot = operation.pilot(options);
  Result result;
  result.error = "broken off";
  double seconds = broken_off_after;
  (void)done_within(watch, broken_off_after, [&] {
    with_threads(1, [&] {
      const double start = processor_seconds();
      try {
        result = operation.run({{}, Allowance()}, pilot.options);
      } catch (const Cancelled&) {
        throw;
      } catch (const std::exception& error) {
        result.error = error.what();
      }
      seconds = processor_seconds() - start;
    });
  });
  const bool failed = result.failed() && result.error != "broken off";
  return {seconds, failed ? seconds : pilot.forecast(seconds, result)};
}

}  // namespace

Piloted run_pilots(const Plan& plan, PilotLimits limits) {
  Piloted found;
  for (std::uint32_t job = 0; job < plan.jobs.size(); ++job) {
    if (plan.group_of(plan.jobs[job]).operation->pilot) found.jobs.push_back(job);
  }
  const Stopwatch watch;
  double taken = 0;
  std::vector<std::size_t> judged;
  found.seconds.resize(found.jobs.size());
  for (const std::size_t k : spread_over(found.jobs.size())) {
    if (!judged.empty() && (taken > limits.processor || watch.seconds() > limits.clock)) break;
    const JobGroup& group = plan.group_of(plan.jobs[found.jobs[k]]);
    const Flight flight = flown(*group.operation, group.options, watch, limits.clock);
    taken += flight.seconds;
    found.seconds[k] = flight.forecast;
    judged.push_back(k);
  }
  found.run = judged.size();
  std::sort(judged.begin(), judged.end());
  for (std::size_t k = 0, nearest = 0; k < found.jobs.size(); ++k) {
    while (nearest + 1 < judged.size() && judged[nearest] + judged[nearest + 1] < 2 * k) ++nearest;
    found.seconds[k] = found.seconds[judged[nearest]];
  }
  return found;
}

}  // namespace lober::detail
