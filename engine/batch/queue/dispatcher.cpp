#include "engine/batch/queue/dispatcher.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/batch/queue/workers.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t window = 256;  // how far ahead a job may overtake

// The work has to wait for memory. No std::exception, so that nobody takes it for an error of the work.
struct Postponed {
  std::size_t bytes;  // the number that it has come to
};

class Dispatcher {
 public:
  Dispatcher(std::vector<ScheduledJob> jobs, CurveCache& cache, bool digests, const std::atomic<bool>& stop,
             JobRunner& runner)
      : jobs_(std::move(jobs)),
        cache_(cache),
        digests_(digests),
        stop_(stop),
        runner_(runner),
        taken_(jobs_.size(), 0) {}

  void run(int threads) {
    try {
      for (int k = 0; k < threads; ++k) start_worker();
    } catch (...) {
      end_with(std::current_exception());
    }
    workers_.wait();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  struct Units {
    std::array<CurveCache::UnitId, 2> ids;
    std::size_t count;
    [[nodiscard]] auto begin() const { return ids.begin(); }
    [[nodiscard]] auto end() const { return ids.begin() + static_cast<std::ptrdiff_t>(count); }
  };
  static Units units_of(const ScheduledJob& job) {
    if (job.unit1 == ScheduledJob::nothing) return {{}, 0};
    return {{job.unit1, job.unit2}, job.unit1 == job.unit2 ? std::size_t{1} : std::size_t{2}};
  }

  // The memory of one reading or one job: the bytes booked before it began, and those that it asks for on top.
  class Booking final : public Allowance {
   public:
    Booking(Dispatcher& dispatcher, std::size_t booked) : dispatcher_(dispatcher), booked_(booked) {}
    ~Booking() override {
      if (more_ == 0) return;  // nearly always
      const std::lock_guard lock(dispatcher_.mutex_);
      dispatcher_.cache_.give(more_);
    }
    [[nodiscard]] std::size_t most() const override { return dispatcher_.cache_.budget(); }
    void book(std::size_t bytes) const override {
      if (bytes > most()) {
        throw DataError("needs more than the " + std::to_string(most() >> 20) + " MiB of memory that are allowed");
      }
      const std::lock_guard lock(dispatcher_.mutex_);
      if (bytes <= booked_ + more_) return;
      const std::size_t more = bytes - booked_ - more_;
      if (!dispatcher_.cache_.free_memory(more) && dispatcher_.running_ > 1) throw Postponed{bytes};
      dispatcher_.cache_.take(more);
      more_ += more;
    }
    void check() const override {
      if (dispatcher_.stop_) throw Cancelled();
    }

   private:
    Dispatcher& dispatcher_;
    std::size_t booked_;
    mutable std::size_t more_ = 0;
  };

  void start_worker() {
    workers_.start([this] {
      // Nothing is thrown out of a task: that would cancel, in the middle, the work of the jobs that other workers run.
      try {
        work();
      } catch (...) {
        end_with(std::current_exception());
      }
    });
  }

  void end_with(const std::exception_ptr& error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = error;
  }

  void work() {
    std::vector<CurveCache::UnitId> to_read;
    to_read.reserve(2);
    std::unique_lock lock(mutex_);
    while (!stop_ && !error_) {
      const std::optional<std::size_t> chosen = choose();
      if (!chosen) {
        if (head_ < jobs_.size()) ++idle_;
        return;
      }
      ScheduledJob& job = jobs_[*chosen];
      to_read.clear();
      for (const CurveCache::UnitId unit : units_of(job)) {
        if (cache_.state(unit) != CurveCache::State::absent) continue;
        cache_.begin_loading(unit);
        to_read.push_back(unit);
      }
      cache_.take(job.working_bytes);
      ++running_;
      lock.unlock();
      const std::exception_ptr thrown = attempt(job, to_read);
      lock.lock();
      --running_;
      cache_.give(job.working_bytes);
      for (const CurveCache::UnitId unit : units_of(job)) cache_.unpin(unit);
      if (thrown) take_back(*chosen, to_read, thrown);
      wake();
    }
  }

  // Reads the units of the list, taking each off it, and runs the job. Returns the exception.
  std::exception_ptr attempt(const ScheduledJob& job, std::vector<CurveCache::UnitId>& to_read) {
    try {
      for (; !to_read.empty(); to_read.erase(to_read.begin())) load(to_read.front());
      isolated([&] { runner_.run_job(job.number, Booking(*this, job.working_bytes)); });
    } catch (...) {
      return std::current_exception();
    }
    return nullptr;
  }

  // Takes back a job, with the lock held.
  void take_back(std::size_t number, const std::vector<CurveCache::UnitId>& unread, const std::exception_ptr& thrown) {
    for (const CurveCache::UnitId unit : unread) cache_.give_up_loading(unit);
    try {
      std::rethrow_exception(thrown);
    } catch (const Postponed& postponed) {
      // Next time that much again is booked at once, so that few attempts are needed.
      const std::size_t expected = std::min(2 * postponed.bytes, cache_.budget());
      if (unread.empty()) {
        jobs_[number].working_bytes = std::max(jobs_[number].working_bytes, expected);
      } else {
        cache_.expect(unread.front(), expected);
      }
      taken_[number] = 0;
      head_ = std::min(head_, number);
    } catch (const Cancelled&) {
      if (!stop_ && !error_) error_ = thrown;
    } catch (...) {
      if (!error_) error_ = thrown;
    }
  }

  void load(CurveCache::UnitId unit) {
    std::size_t booked = 0;
    {
      const std::lock_guard lock(mutex_);
      booked = cache_.bytes(unit) + cache_.reading_memory(unit);
    }
    std::shared_ptr<CurveCache::Loaded> loaded;
    const Booking booking(*this, booked);
    isolated([&] { loaded = cache_.read(unit, {digests_, booking}); });
    const std::lock_guard lock(mutex_);
    cache_.end_loading(unit, *loaded);
    wake();
  }

  void wake() {
    for (; idle_ > 0; --idle_) start_worker();
  }

  // The job to start now, its units pinned; none if there is none that can.
  std::optional<std::size_t> choose() {
    while (head_ < jobs_.size() && taken_[head_] != 0) ++head_;
    std::size_t refused = static_cast<std::size_t>(-1);  // the number of bytes that could not be had
    for (std::size_t k = head_; k < jobs_.size() && k < head_ + window; ++k) {
      if (taken_[k] != 0 || !ready(jobs_[k], refused)) continue;
      taken_[k] = 1;
      return k;
    }
    if (running_ > 0 || head_ == jobs_.size()) return std::nullopt;
    for (const CurveCache::UnitId unit : units_of(jobs_[head_])) cache_.pin(unit);
    cache_.free_memory(bytes_for(jobs_[head_]), true);
    taken_[head_] = 1;
    return head_;  // too large for the budget, so alone
  }

  // Memory that the job takes on top of the memory taken already.
  [[nodiscard]] std::size_t bytes_for(const ScheduledJob& job) const {
    std::size_t bytes = job.working_bytes;
    for (const CurveCache::UnitId unit : units_of(job)) {
      if (cache_.state(unit) == CurveCache::State::absent) bytes += cache_.bytes(unit) + cache_.reading_memory(unit);
    }
    return bytes;
  }

  bool ready(const ScheduledJob& job, std::size_t& refused) {
    for (const CurveCache::UnitId unit : units_of(job)) {
      if (cache_.state(unit) == CurveCache::State::loading) return false;
    }
    const std::size_t bytes = bytes_for(job);
    if (bytes >= refused) return false;
    for (const CurveCache::UnitId unit : units_of(job)) cache_.pin(unit);
    if (cache_.free_memory(bytes)) return true;
    for (const CurveCache::UnitId unit : units_of(job)) cache_.unpin(unit);
    refused = bytes;
    return false;
  }

  std::vector<ScheduledJob> jobs_;
  CurveCache& cache_;
  bool digests_;
  const std::atomic<bool>& stop_;
  JobRunner& runner_;
  std::mutex mutex_;  ///< for all that follows, and for the cache
  std::vector<char> taken_;
  std::size_t head_ = 0;  ///< all before it are taken
  std::size_t running_ = 0, idle_ = 0;
  std::exception_ptr error_;  ///< what ends the run
  WorkerTasks workers_;
};

}  // namespace

void dispatch(std::vector<ScheduledJob> jobs, CurveCache& cache, bool digests, int threads,
              const std::atomic<bool>& stop, JobRunner& runner) {
  Dispatcher(std::move(jobs), cache, digests, stop, runner).run(threads);
}

}  // namespace lober::detail
