#include "cli/mpi/ranks.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <numeric>

#include "cli/mpi/messages.hpp"
#include "engine/jobs/dealer.hpp"
#include "engine/stopwatch.hpp"

namespace lober::cli {
namespace {

static_assert(std::is_trivially_copyable_v<QueueReport>, "a report is sent as it lies in memory");

std::vector<std::uint32_t> all_jobs(const Plan& plan) {
  std::vector<std::uint32_t> jobs(plan.jobs.size());
  std::iota(jobs.begin(), jobs.end(), 0U);
  return jobs;
}

class Coordinator {
 public:
  Coordinator(const SharedWork& work, StoreSession& session, int ranks)
      : session_(session),
        dealer_(work.plan, work.manifest_path, session.pending(), static_cast<std::size_t>(ranks)),
        workers_(ranks - 1),
        runner_(work.plan, work.manifest_path, session.pending(), work.queue) {}

  BatchReport run(const std::function<bool(const QueueProgress&)>& progress) {
    const Stopwatch watch;
    std::thread own([this] { compute(); });
    {
      const Watcher watcher([&] {
        if (progress && !progress(progress_so_far())) stop();
      });
      while (workers_ > 0) {
        if (const std::optional<Message> message = receive_if_any()) {
          answer(*message);
        } else {
          std::this_thread::sleep_for(std::chrono::microseconds(200));  // the cores are for the jobs
        }
      }
      own.join();
    }
    if (error_) std::rethrow_exception(error_);
    report_.queue.jobs = jobs_;
    report_.queue.failed = failed_;
    report_.queue.stopped = jobs_ < session_.pending().size();
    report_.queue.wall_seconds = watch.seconds();
    return report_;
  }

 private:
  void answer(const Message& message) {
    switch (message.tag) {
      case Tag::ready:
        send(message.rank, Tag::jobs, encoded(next()));
        break;
      case Tag::results:
        for (PlanResult& result : decoded_results(message.bytes)) take(std::move(result));
        break;
      case Tag::report: {
        QueueReport report;
        std::memcpy(&report, message.bytes.data(), sizeof(report));
        const std::lock_guard lock(mutex_);
        add(report_.queue, report);
        --workers_;
        break;
      }
      case Tag::jobs:
        break;
    }
  }

  void compute() {
    try {
      QueueReport sum;
      for (std::vector<std::uint32_t> jobs = next(); !jobs.empty(); jobs = next()) {
        add(sum, runner_.run(jobs, [&](PlanResult result) { take(std::move(result)); }));
      }
      const std::lock_guard lock(mutex_);
      add(report_.queue, sum);
    } catch (...) {
      stop();
      error_ = std::current_exception();
    }
  }

  std::vector<std::uint32_t> next() {
    const std::lock_guard lock(mutex_);
    return stopped_ ? std::vector<std::uint32_t>() : dealer_.deal();
  }

  void take(PlanResult result) {
    const std::lock_guard lock(mutex_);
    ++jobs_;
    const bool failed = result.failed;
    if (!session_.add(std::move(result)) || failed) ++failed_;
  }

  // Workers finish the portion that they have.
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

  StoreSession& session_;
  Dealer dealer_;
  int workers_;
  PlanRunner runner_;
  std::mutex mutex_;  ///< for all that follows, the dealer and the session
  bool stopped_ = false;
  std::size_t jobs_ = 0, failed_ = 0;
  BatchReport report_;
  std::exception_ptr error_;
};

}  // namespace

BatchReport coordinate(const SharedWork& work, StoreSession& session, int ranks,
                       const std::function<bool(const QueueProgress&)>& progress) {
  return Coordinator(work, session, ranks).run(progress);
}

void work_for_coordinator(const SharedWork& work) {
  PlanRunner runner(work.plan, work.manifest_path, all_jobs(work.plan), work.queue);
  QueueReport sum;
  for (;;) {
    send(0, Tag::ready, {});
    const std::vector<std::uint32_t> jobs = decoded_jobs(receive().bytes);
    if (jobs.empty()) break;
    // Results are sent from whatever thread has them, one call at a time, while this one waits in `run`.
    std::vector<PlanResult> results;
    Stopwatch since_sent;
    const auto flush = [&] {
      if (!results.empty()) send(0, Tag::results, encoded(results));
      results.clear();
      since_sent = Stopwatch();
    };
    add(sum, runner.run(jobs, [&](PlanResult result) {
      results.push_back(std::move(result));
      if (results.size() >= 1000 || since_sent.seconds() > 0.05) flush();
    }));
    flush();
  }
  std::string bytes(sizeof(sum), '\0');
  std::memcpy(bytes.data(), &sum, sizeof(sum));
  send(0, Tag::report, bytes);
}

void add(QueueReport& sum, const QueueReport& one) {
  sum.points += one.points;
  sum.threads = std::max(sum.threads, one.threads);
  sum.operation_seconds += one.operation_seconds;
  sum.callback_seconds += one.callback_seconds;
  sum.cache.units_read += one.cache.units_read;
  sum.cache.curves_indexed += one.cache.curves_indexed;
  sum.cache.evictions += one.cache.evictions;
  sum.cache.most_reads = std::max(sum.cache.most_reads, one.cache.most_reads);
  sum.cache.peak_bytes = std::max(sum.cache.peak_bytes, one.cache.peak_bytes);
  sum.cache.read_seconds += one.cache.read_seconds;
  sum.cache.prepare_seconds += one.cache.prepare_seconds;
}

}  // namespace lober::cli
