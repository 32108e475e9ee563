#include "engine/jobs/dispatcher.hpp"

#include <array>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/jobs/lanes.hpp"

namespace lober {
namespace {

constexpr std::size_t window = 256;  // how far ahead a job may overtake

class Dispatcher {
 public:
  Dispatcher(std::span<const DispatchedJob> jobs, CurveCache& cache, bool digests, const std::atomic<bool>& stop,
             JobRunner& runner)
      : jobs_(jobs), cache_(cache), digests_(digests), stop_(stop), runner_(runner), taken_(jobs.size(), 0) {}

  void run(int threads) {
    for (int k = 0; k < threads; ++k) {
      lanes_.start([this] { lane(); });
    }
    lanes_.wait();
  }

 private:
  struct Units {
    std::array<CurveCache::UnitId, 2> ids;
    std::size_t count;
    [[nodiscard]] auto begin() const { return ids.begin(); }
    [[nodiscard]] auto end() const { return ids.begin() + static_cast<std::ptrdiff_t>(count); }
  };
  static Units units_of(const DispatchedJob& job) {
    if (job.unit1 == CurveCache::no_unit) return {{}, 0};
    return {{job.unit1, job.unit2}, job.unit1 == job.unit2 ? std::size_t{1} : std::size_t{2}};
  }

  void lane() {
    std::unique_lock lock(mutex_);
    while (!stop_ && !broken_) {
      const std::optional<std::size_t> chosen = choose();
      if (!chosen) {
        if (head_ < jobs_.size()) ++idle_;
        return;
      }
      const DispatchedJob& job = jobs_[*chosen];
      std::vector<CurveCache::UnitId> to_read;
      for (const CurveCache::UnitId unit : units_of(job)) {
        if (cache_.state(unit) != CurveCache::State::absent) continue;
        cache_.begin_loading(unit);
        to_read.push_back(unit);
      }
      cache_.take(job.working_bytes);
      ++running_;
      lock.unlock();
      try {
        for (const CurveCache::UnitId unit : to_read) load(unit);
        isolated([&] { runner_.run_job(job.number); });
      } catch (...) {
        lock.lock();
        broken_ = true;
        throw;
      }
      lock.lock();
      --running_;
      cache_.give(job.working_bytes);
      for (const CurveCache::UnitId unit : units_of(job)) cache_.unpin(unit);
      wake();
    }
  }

  void load(CurveCache::UnitId unit) {
    std::shared_ptr<CurveCache::Loaded> loaded;
    isolated([&] { loaded = cache_.read(unit, digests_); });
    const std::lock_guard lock(mutex_);
    cache_.end_loading(unit, *loaded);
    wake();
  }

  void wake() {
    for (; idle_ > 0; --idle_) {
      lanes_.start([this] { lane(); });
    }
  }

  // The job to start now, its units pinned; none if there is none that can.
  std::optional<std::size_t> choose() {
    while (head_ < jobs_.size() && taken_[head_] != 0) ++head_;
    std::size_t refused = static_cast<std::size_t>(-1);  // so many bytes were not to be had
    for (std::size_t k = head_; k < jobs_.size() && k < head_ + window; ++k) {
      if (taken_[k] != 0 || !ready(jobs_[k], refused)) continue;
      taken_[k] = 1;
      return k;
    }
    if (running_ > 0 || head_ == jobs_.size()) return std::nullopt;
    for (const CurveCache::UnitId unit : units_of(jobs_[head_])) cache_.pin(unit);
    cache_.make_room(bytes_for(jobs_[head_]), true);
    taken_[head_] = 1;
    return head_;  // too large for the budget, so alone
  }

  // Memory that the job takes on top of what is taken.
  [[nodiscard]] std::size_t bytes_for(const DispatchedJob& job) const {
    std::size_t bytes = job.working_bytes;
    for (const CurveCache::UnitId unit : units_of(job)) {
      if (cache_.state(unit) == CurveCache::State::absent) bytes += cache_.bytes(unit) + cache_.reading_memory(unit);
    }
    return bytes;
  }

  bool ready(const DispatchedJob& job, std::size_t& refused) {
    for (const CurveCache::UnitId unit : units_of(job)) {
      if (cache_.state(unit) == CurveCache::State::loading) return false;
    }
    const std::size_t bytes = bytes_for(job);
    if (bytes >= refused) return false;
    for (const CurveCache::UnitId unit : units_of(job)) cache_.pin(unit);
    if (cache_.make_room(bytes)) return true;
    for (const CurveCache::UnitId unit : units_of(job)) cache_.unpin(unit);
    refused = bytes;
    return false;
  }

  std::span<const DispatchedJob> jobs_;
  CurveCache& cache_;
  bool digests_;
  const std::atomic<bool>& stop_;
  JobRunner& runner_;
  std::mutex mutex_;  ///< for all that follows, and for the cache
  std::vector<char> taken_;
  std::size_t head_ = 0;  ///< all before it are taken
  std::size_t running_ = 0, idle_ = 0;
  bool broken_ = false;
  LaneTasks lanes_;
};

}  // namespace

void dispatch(std::span<const DispatchedJob> jobs, CurveCache& cache, bool digests, int threads,
              const std::atomic<bool>& stop, JobRunner& runner) {
  Dispatcher(jobs, cache, digests, stop, runner).run(threads);
}

}  // namespace lober
