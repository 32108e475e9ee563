// Callbacks that throw and runs that are stopped, at random instants: what was thrown comes out, no job runs twice, the
// books stay right.

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <memory>
#include <random>
#include <set>

#include "engine/base/parallel/parallel.hpp"
#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "engine/batch/queue/jobs.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"

namespace lober::detail {
namespace {

struct Thrown : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// An operation whose result shows whether all of its parallel work was done.
Operation summing() {
  Operation sum;
  sum.name = "sum";
  sum.columns = {{"sum", Column::Kind::real}};
  sum.requirements = [](const Options&) { return Requirements{.index = true}; };
  sum.run = [](JobCurves curves, const Options&) {
    std::vector<double> parts(64, 0);
    for (int round = 0; round < 3; ++round) {
      for_each_block(parts.size(), 1, [&](std::size_t k, std::size_t) {
        for (const Point point : curves[k % 2]->curve().points) parts[k] += point.x * point.x;
      });
    }
    double all = 0;
    for (const double part : parts) {
      if (part == 0) throw std::logic_error("work was left out");
      all += part;
    }
    return Result{{all}};
  };
  sum.cost = [](std::size_t points) { return static_cast<double>(points); };
  return sum;
}

class Queue {
 public:
  explicit Queue(JobQueueOptions how) : queue(how), group(queue.add({"", &operation, {}})) {
    for (int k = 0; k < 8; ++k) {
      CurveUnit unit;
      unit.points = 200;
      unit.load = [k](const Loading&) {
        auto curve = std::make_shared<const Curve>(Curve{wavy(200, k), true, "wavy"});
        return std::vector<LoadedCurve>{{curve, {}, {}}};
      };
      curves.push_back(queue.add(std::move(unit))[0]);
    }
  }
  void submit_all() {
    for (const CurveId i : curves) {
      for (const CurveId k : curves) {
        if (i < k) queue.submit({group, i, k});
      }
    }
  }
  Operation operation = summing();
  JobQueue queue;
  std::uint32_t group;
  std::vector<CurveId> curves;
};

TEST(Callbacks, ThatThrowAtRandomInstants) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    // Little memory: an entry in the books that is not taken back would make the next runs wait or run one by one.
    Queue mine({.threads = 1 + round % 4, .memory = std::size_t{400} << 10, .concurrent = round % 3 == 0});
    std::map<std::size_t, int> times;
    std::mutex mutex;
    for (int part = 0; part < 3; ++part) {
      mine.submit_all();
      const std::size_t until = random() % 28;
      std::atomic<std::size_t> calls{0};
      try {
        const QueueReport report = mine.queue.run([&](const Result& result) {
          {
            const std::lock_guard lock(mutex);
            ++times[result.job];
            EXPECT_EQ(result.error, "");
          }
          if (part < 2 && calls++ == until) throw Thrown("enough");
        });
        EXPECT_EQ(part, 2);
        EXPECT_EQ(report.jobs, 28U);
        EXPECT_LE(report.cache.peak_bytes, std::size_t{400} << 10);
      } catch (const Thrown&) {
        EXPECT_LT(part, 2);
      }
    }
    for (const auto& [job, count] : times) EXPECT_EQ(count, 1) << job;
    EXPECT_EQ(times.lower_bound(56) == times.end() ? 0 : std::distance(times.lower_bound(56), times.end()), 28);
  }
}

TEST(Callbacks, AreNotCalledAgainAfterTheyThrew) {
  for (int round = 0; round < 30; ++round) {
    Queue mine({.threads = 4});
    mine.submit_all();
    int calls = 0;
    EXPECT_THROW(mine.queue.run([&](const Result&) {
      ++calls;
      throw Thrown("enough");
    }),
                 Thrown);
    EXPECT_EQ(calls, 1);
  }
}

TEST(Callbacks, StoppedAtRandomInstants) {
  std::mt19937 random(6);
  for (int round = 0; round < 30; ++round) {
    Queue mine({.threads = 1 + round % 4});
    std::set<std::size_t> seen;
    mine.submit_all();
    std::thread stopper([&, after = random() % 3000] {
      std::this_thread::sleep_for(std::chrono::microseconds(after));
      mine.queue.stop();
    });
    const QueueReport report = mine.queue.run([&](const Result& result) {
      EXPECT_TRUE(seen.insert(result.job).second);
      EXPECT_EQ(result.error, "");
    });
    stopper.join();
    EXPECT_EQ(report.jobs, seen.size());
    EXPECT_EQ(report.stopped, seen.size() < 28);
  }
}

TEST(Callbacks, AStopBeforeTheRunIsNotLost) {
  Queue mine({});
  mine.submit_all();
  mine.queue.stop();
  const QueueReport report = mine.queue.run([](const Result&) { ADD_FAILURE(); });
  EXPECT_TRUE(report.stopped);
  mine.submit_all();
  EXPECT_EQ(mine.queue.run([](const Result&) {}).jobs, 28U);
}

TEST(Callbacks, MayNotSubmit) {
  Queue mine({.threads = 3});
  mine.submit_all();
  const auto expect_refused = [&](const auto& call) {
    try {
      mine.queue.run([&](const Result&) { call(); });
      ADD_FAILURE() << "was not refused";
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("the queue is running"), std::string::npos) << error.what();
    }
    mine.submit_all();
  };
  expect_refused([&] { mine.submit_all(); });
  expect_refused([&] { mine.queue.add(Curve{wavy(10, 0), true, "late"}); });
  expect_refused([&] { mine.queue.run([](const Result&) {}); });
  EXPECT_EQ(mine.queue.run([](const Result&) {}).jobs, 28U);
}

// A reading or an index that runs out of memory, or a loader that throws whatever it likes, is an error of that curve.
TEST(Callbacks, UnitsThatThrowFailTheirJobsOnly) {
  Queue mine({.threads = 2});
  int number = 0;
  for (const auto& fail :
       std::vector<std::function<void()>>{[] { throw std::bad_alloc(); }, [] { throw std::length_error("too long"); },
                                          [] { throw Thrown("broken"); }}) {
    CurveUnit unit;
    unit.points = 10;
    unit.load = [fail](const Loading&) -> std::vector<LoadedCurve> {
      fail();
      return {};
    };
    mine.curves.push_back(mine.queue.add(std::move(unit))[0]);
    ++number;
  }
  mine.submit_all();
  std::map<std::string, int> errors;
  const QueueReport report = mine.queue.run([&](const Result& result) { ++errors[result.error]; });
  EXPECT_EQ(report.jobs, 55U);
  EXPECT_EQ(errors[""], 28);
  EXPECT_EQ(report.failed, 27U);
  EXPECT_GT(errors["out of memory"], 0);
  EXPECT_GT(errors["broken"], 0);
}

// Bytes that no machine has: the loader says how many points there are, and the index asks for memory.
TEST(Callbacks, WorkThatGrowsIsPutBackUntilThereIsRoom) {
  constexpr std::size_t budget = std::size_t{8} << 20;
  for (int threads = 1; threads <= 4; ++threads) {
    JobQueue queue({.threads = threads, .memory = budget});
    std::atomic<std::size_t> held{0}, most{0};
    std::atomic<int> loads{0};
    std::vector<CurveId> curves;
    for (int k = 0; k < 6; ++k) {
      CurveUnit unit;
      unit.points = 10;
      unit.load = [&, k](const Loading& loading) {
        ++loads;
        struct Holding {
          std::atomic<std::size_t>& sum;
          std::size_t bytes = 0;
          ~Holding() { sum -= bytes; }
        } holding{held};
        const std::size_t wanted = (k == 5 ? 2 : 1) * budget * 3 / 4;  // the last one never fits
        for (std::size_t bytes = budget / 32; bytes <= wanted; bytes += budget / 32) {
          loading.allowance.book(bytes);
          held += bytes - holding.bytes;
          holding.bytes = bytes;
          most = std::max(most.load(), held.load());
          std::this_thread::sleep_for(std::chrono::microseconds(50));
        }
        return std::vector<LoadedCurve>{{std::make_shared<const Curve>(Curve{wavy(50, k), true, "grown"}), {}, {}}};
      };
      curves.push_back(queue.add(std::move(unit))[0]);
    }
    Operation count;
    count.name = "count";
    count.arity = Arity::one;
    count.requirements = [](const Options&) { return Requirements{}; };
    count.run = [](JobCurves jobs, const Options&) {
      return Result{{static_cast<double>(jobs[0]->curve().points.size())}};
    };
    count.cost = [](std::size_t) { return 1.0; };
    const std::uint32_t group = queue.add({"", &count, {}});
    for (const CurveId curve : curves) queue.submit({group, curve});
    std::map<std::size_t, std::string> errors;
    const QueueReport report = queue.run([&](const Result& result) { errors[result.job] = result.error; });
    EXPECT_EQ(report.jobs, 6U);
    EXPECT_EQ(report.failed, 1U);
    EXPECT_NE(errors[5].find("8 MiB of memory"), std::string::npos) << errors[5];
    EXPECT_LE(most.load(), budget);
    EXPECT_LE(report.cache.peak_bytes, budget + (std::size_t{1} << 20));
    EXPECT_LE(loads.load(), 30);
  }
}

class CallbacksOfABatch : public ScratchFolder {
 protected:
  CallbacksOfABatch() {
    for (int k = 0; k < 12; ++k) write_npy(path("c." + std::to_string(k)), wavy(20'000, k));
    write("job.toml", "operation = \"overlay\"\ncurves = \"c.*\"\ngrid = { index = [\"tree\", \"grid\", \"kd\"] }\n");
  }
  BatchReport ran(const std::function<bool(const QueueProgress&)>& progress) const {
    return run_batch(read_manifest(path("job.toml")), {path("s"), {}, {.threads = 2}, progress});
  }
};

TEST_F(CallbacksOfABatch, WhatProgressThrowsComesOutAndWhatIsDoneStays) {
  bool asked = false;
  try {
    ran([&](const QueueProgress&) -> bool {
      asked = true;
      throw Thrown("enough");
    });
    EXPECT_FALSE(asked) << "what was thrown is lost";
  } catch (const Thrown&) {
    EXPECT_TRUE(asked);
  }
  const ExportCounts some = survey(Store::open(path("s"))).counts;
  const BatchReport rest = ran({});
  EXPECT_EQ(rest.finished_before, some.done);
  EXPECT_EQ(survey(Store::open(path("s"))).counts.done, 66U * 3);
}

// The store goes while the first jobs run: the run ends soon, not after all of them. There are enough that no processor
// is through with them before progress is asked for.
TEST_F(CallbacksOfABatch, AStoreThatVanishesEndsTheRun) {
  for (int k = 12; k < 60; ++k) write_npy(path("c." + std::to_string(k)), wavy(20'000, k));
  EXPECT_THROW(ran([&](const QueueProgress&) {
                 std::filesystem::remove(path("s"));
                 return true;
               }),
               DataError);
  EXPECT_TRUE(std::filesystem::exists(path("s.rescued")));
}

}  // namespace
}  // namespace lober::detail
