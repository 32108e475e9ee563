#include "engine/batch/queue/jobs.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <set>

#include "engine/base/machine_memory.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/batch/queue/dispatcher.hpp"
#include "engine/batch/queue/schedule.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

void add_to(std::atomic<double>& sum, double value) {
  sum.store(sum.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);  // under a lock
}

// The digest of a curve in memory: of its points and of whether it is closed.
std::string digest_of(const Curve& curve) {
  return sha256(std::as_bytes(std::span(curve.points))) + (curve.closed ? "" : " open");
}

// Bytes that a job takes besides its curves, unless they cross very often.
std::size_t working_memory(const Operation& operation, std::size_t points) {
  return (std::size_t{1} << 16) + 8 * points + operation.memory;
}

}  // namespace

JobQueue::JobQueue(const JobQueueOptions& options) : options_(options) {
  if (options_.memory == 0) options_.memory = machine_memory() / 2;
  cache_ = std::make_unique<CurveCache>(options_.memory, options_.kept);
}

JobQueue::~JobQueue() = default;

void JobQueue::refuse_if_running(const char* what) const {
  if (running_) throw UsageError(std::string(what) + ": the queue is running; wait for the end of run");
}

CurveId JobQueue::add(Curve curve) {
  refuse_if_running("add");
  CurveUnit unit;
  unit.points = curve.points.size();
  unit.keep = true;
  auto held = std::make_shared<const Curve>(std::move(curve));
  unit.load = [held](const Loading& loading) {
    return std::vector<LoadedCurve>{{held, loading.digests ? digest_of(*held) : std::string(), {}}};
  };
  return cache_->add(std::move(unit))[0];
}

std::vector<CurveId> JobQueue::add(CurveUnit unit) {
  refuse_if_running("add");
  return cache_->add(std::move(unit));
}

std::uint32_t JobQueue::add(JobGroup group) {
  refuse_if_running("add");
  requirements_.push_back(group.operation->requirements(group.options));
  groups_.push_back(std::move(group));
  return static_cast<std::uint32_t>(groups_.size() - 1);
}

void JobQueue::reserve(std::size_t jobs) {
  refuse_if_running("reserve");
  jobs_.reserve(jobs_.size() + jobs);
}

std::size_t JobQueue::submit(Job job) {
  refuse_if_running("submit");
  const JobGroup& group = groups_.at(job.group);
  const Operation* const operation = group.operation;
  const std::size_t count = job.curves().size();
  if (!takes(operation->arity, count)) {
    throw UsageError(operation->name + " does not take " + std::to_string(count) + " curves");
  }
  for (const CurveId curve : job.curves()) cache_->require(curve, requirements_[job.group]);
  jobs_.push_back(job);
  return jobs_.size() - 1;
}

void JobQueue::stop() {
  stop_.store(true);
}

void JobQueue::cancel() {
  stop_.store(true);
  cancelled_.store(true);
}

QueueProgress JobQueue::progress() const {
  return {counters_.jobs, counters_.done, counters_.failed, counters_.cost, counters_.cost_done, counters_.points};
}

namespace {

// The second curve of a pair moved by whole periods to the first; null where it is there already.
std::unique_ptr<const PreparedCurve> moved_near(const PreparedCurve& second, const Curve& first, const JobGroup& group,
                                                const Requirements& requirements) {
  const Curve& given = second.curve();
  if (!group.periods.any() || given.points.empty()) return nullptr;
  Curve curve = given;
  move_near(curve.points, first.points, group.periods);
  if (curve.points.front() == given.points.front()) return nullptr;
  return std::make_unique<const PreparedCurve>(std::make_shared<const Curve>(std::move(curve)), requirements);
}

}  // namespace

// One call of `run`: what the dispatcher asks of the jobs.
class JobQueue::Run final : public JobRunner {
 public:
  Run(JobQueue& queue, const std::function<void(Result&&)>& done) : queue_(queue), done_(done) {}

  void run_job(std::uint32_t number, const Allowance& allowance) override {
    const Job& job = queue_.jobs_[number];
    const JobGroup& group = queue_.groups_[job.group];
    const Requirements& requirements = queue_.requirements_[job.group];
    const CurveCache& cache = *queue_.cache_;
    Result result;
    std::array<const PreparedCurve*, 2> curves{};
    const CurvePair ids = job.curves();
    std::size_t points = 0;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      curves[k] = &cache.curve(ids[k]);
      points += curves[k]->curve().points.size();
      if (!result.failed()) result.error = curves[k]->error(requirements);
      warn(curves[k]->warning());
    }
    Stopwatch watch;
    if (!result.failed()) {
      try {
        std::unique_ptr<const PreparedCurve> moved;
        if (ids.size() == 2) {
          require_same_columns(curves[0]->curve(), curves[1]->curve());
          if (!group.periods.any()) warn_of_longitudes(*curves[0], *curves[1]);
          moved = moved_near(*curves[1], curves[0]->curve(), group, requirements);
          if (moved != nullptr) curves[1] = moved.get();
          if (moved != nullptr && !moved->error(requirements).empty()) throw DataError(moved->error(requirements));
          warn(period_warning(curves[0]->curve(), curves[1]->curve(), group.periods));
        }
        result = group.operation->run({std::span(curves).first(ids.size()), allowance, group.outputs}, group.options);
      } catch (const Cancelled&) {
        throw;
      } catch (const std::bad_alloc&) {
        result.error = "out of memory";
      } catch (const std::exception& error) {
        result.error = *error.what() != '\0' ? error.what() : "failed without a message";
      }
    }
    result.seconds = watch.lap();
    result.job = number;
    for (std::size_t k = 0; k < ids.size(); ++k) result.digests[k] = cache.digest(ids[k]);
    const double seconds = result.seconds;
    const bool failed = result.failed();
    if (!hand_over(std::move(result))) return;
    count(points, failed, costs[number - queue_.first_waiting_], seconds, watch.lap());
  }

  [[nodiscard]] std::vector<std::string> warnings() const { return {warned_.begin(), warned_.end()}; }

  std::vector<double> costs;  ///< costs of the jobs that wait
  QueueReport report;

 private:
  // False after a call that threw.
  bool hand_over(Result&& result) {
    std::unique_lock lock(callback_, std::defer_lock);
    if (!queue_.options_.concurrent) lock.lock();
    if (thrown_) return false;
    try {
      done_(std::move(result));
    } catch (...) {
      thrown_ = true;
      throw;
    }
    return true;
  }

  // A curve that jumps has a warning of its own, with the same remedy, and its box is that of the whole map.
  void warn_of_longitudes(const PreparedCurve& first, const PreparedCurve& second) {
    if (!first.warning().empty() || !second.warning().empty()) return;
    const std::string warning = longitudes_warning(first.curve(), second.curve());
    if (!warning.empty()) warn(warning + "; the manifest needs " + period_of_longitudes(first.curve()));
  }

  // Each line once.
  void warn(const std::string& line) {
    if (line.empty()) return;
    const std::lock_guard lock(counting_);
    if (warned_.size() < max_warnings) warned_.insert(line);
  }

  void count(std::size_t points, bool failed, double cost, double seconds, double callback_seconds) {
    const std::lock_guard lock(counting_);
    Counters& counters = queue_.counters_;
    counters.done.fetch_add(1, std::memory_order_relaxed);
    counters.failed.fetch_add(failed ? 1 : 0, std::memory_order_relaxed);
    counters.points.fetch_add(points, std::memory_order_relaxed);
    add_to(counters.cost_done, cost);
    ++report.jobs;
    report.failed += failed ? 1 : 0;
    report.points += points;
    report.operation_seconds += seconds;
    report.callback_seconds += callback_seconds;
  }

  static constexpr std::size_t max_warnings = 1000;

  JobQueue& queue_;
  const std::function<void(Result&&)>& done_;
  std::mutex callback_, counting_;
  std::atomic<bool> thrown_{false};
  std::set<std::string> warned_;
};

// Marks that `run` works: however it ends, no job waits any more, and a wish to stop was for this run.
class JobQueue::Running {
 public:
  explicit Running(JobQueue& queue) : queue_(queue) {
    if (queue.running_.exchange(true)) throw UsageError("run: the queue is running; wait for the end of run");
  }
  ~Running() {
    queue_.first_waiting_ = queue_.jobs_.size();
    queue_.stop_ = false;
    queue_.running_ = false;
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  JobQueue& queue_;
};

QueueReport JobQueue::run(const std::function<void(Result&&)>& done) {
  const Stopwatch watch;
  if (cancelled_) throw UsageError("the queue was cancelled: it runs nothing more");
  const Running running(*this);
  Run run(*this, done);
  const std::span<const Job> waiting = std::span(jobs_).subspan(first_waiting_);
  std::vector<ScheduledJob> scheduled;
  std::vector<std::size_t> unit_bytes;
  scheduled.reserve(waiting.size());
  run.costs.reserve(waiting.size());
  double total_cost = 0;
  std::size_t working = 0, reading = 0;  // what a thread takes at most, for a job and to read
  for (const Job& job : waiting) {
    const Operation& operation = *groups_[job.group].operation;
    const CurvePair ids = job.curves();
    ScheduledJob next;
    next.number = static_cast<std::uint32_t>(first_waiting_ + scheduled.size());
    std::size_t points = 0;
    for (const CurveId id : ids) {
      const CurveCache::UnitId unit = cache_->unit_of(id);
      if (unit_bytes.size() <= unit) unit_bytes.resize(unit + std::size_t{1});
      unit_bytes[unit] = cache_->bytes(unit);
      points += cache_->points(id);
      reading = std::max(reading, cache_->reading_memory(unit) + cache_->bytes(unit));
    }
    if (ids.size() > 0) {
      next.unit1 = cache_->unit_of(ids[0]);
      next.unit2 = cache_->unit_of(ids[ids.size() - 1]);
    }
    next.cost = operation.cost(points);
    next.working_bytes = working_memory(operation, points);
    working = std::max(working, next.working_bytes);
    total_cost += next.cost;
    run.costs.push_back(next.cost);
    scheduled.push_back(next);
  }
  const int threads = options_.threads > 0 ? options_.threads : concurrency();
  // Besides curves that stay.
  const auto less = [&](std::size_t bytes) {
    const std::size_t taken = static_cast<std::size_t>(threads) * bytes;
    return std::max(options_.memory / 4, options_.memory - std::min(options_.memory, taken));
  };
  const std::vector<std::uint32_t> order = schedule(scheduled, unit_bytes, {less(working), less(working + reading)});
  std::vector<ScheduledJob> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t k : order) ordered.push_back(scheduled[k]);
  counters_.jobs = jobs_.size();
  add_to(counters_.cost, total_cost);

  const CacheCounts before = cache_->counts();
  run.report.threads = threads;
  try {
    const CancellationScope scope(cancelled_);
    with_threads(threads, [&] { dispatch(std::move(ordered), *cache_, options_.digests, threads, stop_, run); });
  } catch (const Cancelled&) {
    if (!cancelled_) throw;
  }
  run.report.warnings = run.warnings();
  run.report.stopped = run.report.jobs < waiting.size();
  run.report.cache = cache_->counts();
  run.report.cache.units_read -= before.units_read;
  run.report.cache.curves_indexed -= before.curves_indexed;
  run.report.cache.evictions -= before.evictions;
  run.report.cache.read_seconds -= before.read_seconds;
  run.report.cache.prepare_seconds -= before.prepare_seconds;
  run.report.wall_seconds = watch.seconds();
  return run.report;
}

}  // namespace lober::detail
