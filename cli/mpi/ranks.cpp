#include "cli/mpi/ranks.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <numeric>
#include <utility>

#include "cli/mpi/messages.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/batch/operations/result.hpp"
#include "engine/batch/plan_outputs.hpp"
#include "engine/batch/work_queue.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_bytes = std::size_t{32} << 20;  // bytes of results that wait to be sent

std::vector<std::uint32_t> all_jobs(const detail::Plan& plan) {
  std::vector<std::uint32_t> jobs(plan.jobs.size());
  std::iota(jobs.begin(), jobs.end(), 0U);
  return jobs;
}

std::size_t size_of(const detail::Result& result) {
  std::size_t numbers = result.values.size();
  for (const std::vector<double>& list : result.lists) numbers += list.size();
  return sizeof(double) * numbers + result.error.size();
}

class Coordinator {
 public:
  Coordinator(const SharedWork& work, detail::StoreSession& session, int ranks, const std::atomic<bool>& broken)
      : session_(session),
        broken_(broken),
        queue_(work.plan, work.manifest_path, session.pending(), static_cast<std::size_t>(ranks)),
        at_work_(static_cast<std::size_t>(ranks), true),
        workers_(ranks - 1),
        outputs_(detail::output_folder_of(work.output_root, work.manifest_path, work.plan, work.store)),
        runner_(work.plan, work.manifest_path, session.pending(), work.queue, &outputs_) {}

  BatchReport run(const std::function<bool(const QueueProgress&)>& progress) {
    const detail::Stopwatch watch;
    own_ = std::thread([this] { compute(); });
    detail::ProgressTimer timer([&] {
      try {
        if (progress && !progress(progress_so_far())) stop();
      } catch (...) {
        note(std::current_exception());
      }
    });
    while (workers_ > 0 || !computed_) {
      check();
      if (const std::optional<Message> message = receive_if_any()) {
        answer(*message);
      } else {
        std::this_thread::sleep_for(std::chrono::microseconds(200));  // the cores are for the jobs
      }
    }
    check();
    own_.join();
    timer.finish();
    report_.queue.jobs = jobs_;
    report_.queue.failed = failed_;
    report_.queue.stopped = jobs_ < session_.pending().size();
    report_.queue.wall_seconds = watch.seconds();
    return report_;
  }

  // Commits the results that have come in, before all ends.
  void save() {
    const std::lock_guard lock(mutex_);
    session_.finish("broken off by a failure");
  }

 private:
  void answer(const Message& message) {
    switch (message.tag) {
      case Tag::ready:
        give_jobs(message.rank);
        break;
      case Tag::results:
        for (detail::Result& result : detail::decoded_results(message.bytes)) take(std::move(result));
        break;
      case Tag::report: {
        const QueueReport report = decoded_report(message.bytes);
        const std::lock_guard lock(mutex_);
        add(report_.queue, report);
        --workers_;
        break;
      }
      case Tag::jobs:
      case Tag::stop:
      case Tag::more:
        break;
    }
  }

  void give_jobs(int rank) {
    const std::vector<std::uint32_t> jobs = next();
    at_work_[static_cast<std::size_t>(rank)] = !jobs.empty();
    send(rank, Tag::jobs, encoded(jobs));
  }

  // Checks for errors of other threads: only this one speaks to the other ranks.
  void check() {
    std::exception_ptr error;
    bool stopped = false;
    {
      const std::lock_guard lock(mutex_);
      error = error_;
      stopped = stopped_;
    }
    if (error) std::rethrow_exception(error);
    if (broken_) throw DataError("the store cannot be written any more");
    if (!stopped || std::exchange(stop_sent_, true)) return;
    for (std::size_t rank = 1; rank < at_work_.size(); ++rank) {
      if (at_work_[rank]) send(static_cast<int>(rank), Tag::stop, {});
    }
  }

  void note(const std::exception_ptr& error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = error;
  }

  void compute() {
    try {
      QueueReport sum;
      for (std::vector<std::uint32_t> jobs = next(); !jobs.empty(); jobs = next()) {
        add(sum, runner_.run(jobs, [&](detail::Result&& result) { take(std::move(result)); }));
      }
      const std::lock_guard lock(mutex_);
      add(report_.queue, sum);
    } catch (...) {
      note(std::current_exception());
    }
    computed_ = true;
  }

  std::vector<std::uint32_t> next() {
    const std::lock_guard lock(mutex_);
    return stopped_ ? std::vector<std::uint32_t>() : queue_.next_portion();
  }

  void take(detail::Result&& result) {
    const std::lock_guard lock(mutex_);
    ++jobs_;
    const bool failed = result.failed();
    if (!session_.add(std::move(result)) || failed) ++failed_;
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    runner_.stop();
  }

  QueueProgress progress_so_far() {
    const std::lock_guard lock(mutex_);
    const auto all = static_cast<double>(session_.pending().size());
    return {session_.pending().size(), jobs_, failed_, all, static_cast<double>(jobs_), report_.queue.points};
  }

  detail::StoreSession& session_;
  const std::atomic<bool>& broken_;
  detail::WorkQueue queue_;
  std::vector<bool> at_work_;  ///< by rank: may have jobs, or ask for some
  int workers_;                ///< that have not reported yet
  detail::OutputFolder outputs_;
  detail::PlanRunner runner_;
  std::mutex mutex_;  ///< for all that follows, the work queue and the session
  bool stopped_ = false, stop_sent_ = false;
  std::size_t jobs_ = 0, failed_ = 0;
  BatchReport report_;
  std::exception_ptr error_;
  std::atomic<bool> computed_{false};
  std::thread own_;
};

// All that a worker does.
void work_until_done(const SharedWork& work) {
  const detail::OutputFolder outputs =
      detail::output_folder_of(work.output_root, work.manifest_path, work.plan, work.store);
  detail::PlanRunner runner(work.plan, work.manifest_path, all_jobs(work.plan), work.queue, &outputs);
  QueueReport sum;
  for (;;) {
    send(0, Tag::ready, {});
    Message answer = receive();
    while (answer.tag != Tag::jobs) answer = receive();  // it has stopped already
    const std::vector<std::uint32_t> jobs = decoded_jobs(answer.bytes);
    if (jobs.empty()) break;
    // Results are sent from whatever thread has them, one call at a time, while this one waits in `run`.
    std::vector<detail::Result> results;
    std::size_t bytes = 0;
    detail::Stopwatch since_sent;
    const auto flush = [&] {
      if (!results.empty()) send(0, Tag::results, detail::encoded(results));
      results.clear();
      bytes = 0;
      since_sent = detail::Stopwatch();
    };
    add(sum, runner.run(jobs, [&](detail::Result&& result) {
      try {
        bytes += size_of(result);
        results.push_back(std::move(result));
        if (results.size() >= 1000 || bytes >= max_bytes || since_sent.seconds() > 0.05) flush();
        if (const std::optional<Message> message = receive_if_any(); message && message->tag == Tag::stop)
          runner.stop();
      } catch (...) {  // at once, not when the jobs that run have ended
        const Failure failure = failure_of(std::current_exception());
        abandon(failure.message, failure.status);
      }
    }));
    flush();
  }
  send(0, Tag::report, encoded(sum));
}

}  // namespace

BatchReport coordinate(const SharedWork& work, detail::StoreSession& session, int ranks,
                       const std::function<bool(const QueueProgress&)>& progress, const std::atomic<bool>& broken) {
  std::optional<Coordinator> coordinator;
  try {
    coordinator.emplace(work, session, ranks, broken);
    return coordinator->run(progress);
  } catch (...) {
    Failure failure = failure_of(std::current_exception());
    if (coordinator) {
      try {
        coordinator->save();
      } catch (const std::exception& error) {  // which says more about a broken store
        failure = {error.what(), 1};
      }
    }
    abandon(failure.message, failure.status);
  }
}

void work_for_coordinator(SharedWork& work, const std::string& plan) {
  try {
    work.plan = detail::Plan::decoded(plan);
    work_until_done(work);
  } catch (...) {
    const Failure failure = failure_of(std::current_exception());
    abandon(failure.message, failure.status);
  }
}

Failure failure_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const UsageError& error) {
    return {error.what(), 2};
  } catch (const Cancelled& error) {
    return {error.what(), 130};
  } catch (const std::bad_alloc&) {
    return {"out of memory", 1};
  } catch (const std::exception& error) {
    return {error.what(), 1};
  } catch (...) {
    return {"unknown failure", 1};
  }
}

void add(QueueReport& sum, const QueueReport& one) {
  sum.points += one.points;
  sum.threads = std::max(sum.threads, one.threads);
  sum.operation_seconds += one.operation_seconds;
  sum.callback_seconds += one.callback_seconds;
  sum.cache.units_read += one.cache.units_read;
  sum.cache.curves_indexed += one.cache.curves_indexed;
  sum.cache.evictions += one.cache.evictions;
  sum.cache.max_reads = std::max(sum.cache.max_reads, one.cache.max_reads);
  sum.cache.peak_bytes = std::max(sum.cache.peak_bytes, one.cache.peak_bytes);
  sum.cache.read_seconds += one.cache.read_seconds;
  sum.cache.prepare_seconds += one.cache.prepare_seconds;
}

}  // namespace lober::cli
