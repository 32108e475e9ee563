#include "engine/batch/batch.hpp"
#include "engine/batch/plan_outputs.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/batch/export/export.hpp"
#include "engine/batch/store/store_file.hpp"
#include "lober/base/cancellation.hpp"

namespace lober {
using namespace detail;
namespace {

// The digests of the inputs of these jobs as they are now; empty for inputs that cannot be read.
std::vector<std::string> hash_inputs(const Plan& plan, std::span<const std::uint32_t> jobs,
                                     const std::string& manifest_path) {
  std::vector<std::string> digests(plan.curves.size());
  const std::vector<std::vector<CurveId>> units = units_of(plan, jobs);
  for_each_block(units.size(), 1, [&](std::size_t k, std::size_t) {
    try {
      const std::vector<std::string> all = digests_of(sources_of(plan, units[k]), manifest_path);
      for (std::size_t i = 0; i < all.size(); ++i) digests[units[k][i]] = all[i];
    } catch (const DataError&) {  // the jobs will say so
    }
  });
  return digests;
}

std::string text_of(Shard shard) {
  return std::to_string(shard.number + 1) + "/" + std::to_string(shard.of);
}

}  // namespace

StoreSession::StoreSession(const std::string& store_path, const Plan& plan, const Manifest& manifest, Shard shard,
                           int threads, std::function<void()> broken)
    : plan_(plan), store_(Store::create(store_path)), digests_(plan.curves.size()), seen_(plan.curves.size(), 0) {
  store_->begin_run(provenance(), threads, manifest, text_of(shard), plan);
  pending_ = jobs_of(plan, shard);
  InputDigests inputs;
  if (!store_->stored().empty()) {
    skip_finished(hash_inputs(plan, pending_, manifest.path));
    for (CurveId id = 0; id < seen_.size(); ++id) {
      if (seen_[id] != 0) inputs.emplace(plan.curves[id].input_name(), digests_[id]);
    }
    store_->show(inputs);
    for (const auto& [key, known] : store_->stored()) hidden_ += known.job == no_job && !known.damaged ? 1 : 0;
  }
  writer_ = std::make_unique<ResultWriter>(*store_, std::move(broken));
  for (const auto& [name, digest] : inputs) writer_->add(name, digest);
}

StoreSession::~StoreSession() = default;

void StoreSession::skip_finished(std::vector<std::string> inputs) {
  const JobKeys keys(plan_);
  std::vector<std::uint32_t> left;
  digests_ = std::move(inputs);
  for (const std::uint32_t number : pending_) {
    const Job& job = plan_.jobs[number];
    std::array<std::string_view, 2> digests;
    for (std::size_t k = 0; k < job.curves().size(); ++k) {
      seen_[job.curves()[k]] = 1;
      digests[k] = digests_[job.curves()[k]];
    }
    const JobKey key = keys(job, digests[0], digests[1]);
    const Store::Known* const known = store_->stored().find(key);
    if (known != nullptr && !store_->result(*known)) {
      store_->discard(key);
      damaged_.push_back(damage_line(*store_, plan_, number));
    } else if (known != nullptr && !known->failed) {
      continue;
    }
    left.push_back(number);
  }
  finished_before_ = pending_.size() - left.size();
  pending_ = std::move(left);
}

void StoreSession::note(CurveId curve, std::string_view digest, bool& usable) {
  if (seen_[curve] == 0) {
    seen_[curve] = 1;
    digests_[curve] = digest;
    writer_->add(plan_.curves[curve].input_name(), digests_[curve]);
  } else if (digests_[curve] != digest) {
    usable = false;
  }
}

bool StoreSession::add(Result&& result) {
  const Job& job = plan_.jobs[result.job];
  bool usable = true;
  const CurvePair curves = job.curves();
  for (std::size_t k = 0; k < curves.size(); ++k) note(curves[k], result.digests[k], usable);
  result.digests = {};  // views that may end before the results are written
  if (usable) writer_->add(std::move(result));
  return usable;
}

double StoreSession::finish(const std::string& how) {
  writer_->finish();
  stored_meanwhile_ = store_->stored_meanwhile();
  store_->end_run(how);
  store_.reset();  // which brings the log into the file
  return writer_->seconds();
}

BatchReport detail::run_batch(const Manifest& manifest, const BatchOptions& options) {
  const Stopwatch watch;
  BatchReport report;
  const Plan plan = make_plan(manifest);
  const OutputFolder outputs = output_folder_of(options.output_root, manifest.path, plan, options.store);
  accept_outputs(outputs, manifest.path, plan);
  (void)jobs_of(plan, options.shard);  // refused before there is a store
  std::atomic<bool> broken{false};
  StoreSession session(options.store, plan, manifest, options.shard, options.queue.threads, [&] { broken = true; });
  report.jobs = session.pending().size() + session.finished_before();
  report.finished_before = session.finished_before();
  report.damaged = session.damaged();
  report.hidden = session.hidden();
  std::size_t unusable = 0;
  {
    PlanRunner queue(plan, manifest.path, session.pending(), options.queue, &outputs);
    std::optional<Stopwatch> since_stop;
    ProgressTimer timer([&] {
      try {
        if (!since_stop && !broken && (!options.progress || options.progress(queue.progress()))) return;
        if (!since_stop) since_stop.emplace();
        queue.stop();
        if (since_stop->seconds() >= options.patience) queue.cancel();
      } catch (...) {
        queue.stop();
        throw;
      }
    });
    // Jobs that run when the caller is cancelled have their chance too.
    const CancellationScope shield(CancellationScope::Shield{});
    report.queue = queue.run(session.pending(), [&](Result&& result) {
      const bool failed = result.failed();
      if (!session.add(std::move(result)) && !failed) ++unusable;
    });
    timer.finish();
  }
  report.queue.failed += unusable;
  const CancellationScope shield(CancellationScope::Shield{});
  report.store_seconds = session.finish(report.queue.stopped ? "stopped" : "complete");
  report.stored_meanwhile = session.stored_meanwhile();
  report.wall_seconds = watch.seconds();
  return report;
}

ProgressTimer::ProgressTimer(std::function<void()> watch)
    : thread_([this, watch = std::move(watch)] {
        std::unique_lock lock(mutex_);
        try {
          while (!wake_.wait_for(lock, std::chrono::milliseconds(100), [&] { return done_; })) watch();
        } catch (...) {
          error_ = std::current_exception();
        }
      }) {}

ProgressTimer::~ProgressTimer() {
  try {
    finish();
  } catch (...) {  // whoever wants to know calls `finish`
  }
}

void ProgressTimer::finish() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

std::vector<std::string> merge_stores(const std::string& target, const std::vector<std::string>& stores,
                                      const Progress& progress) {
  std::vector<std::string> all{target};
  all.insert(all.end(), stores.begin(), stores.end());
  require_different_stores(all);
  std::vector<Store> others;
  others.reserve(stores.size());
  for (const std::string& store : stores) others.push_back(Store::open(store));
  const bool is_new = !std::filesystem::exists(target);
  std::optional<Store> joined(Store::create(target));
  std::vector<std::size_t> with_damage;
  try {
    with_damage = joined->merge(others, progress);
  } catch (...) {
    const bool is_empty = joined->runs().empty();  // another process may have begun one there
    joined.reset();                                // and SQLite removes its log
    if (is_new && is_empty) std::filesystem::remove(target);
    throw;
  }
  std::vector<std::string> damaged;
  for (const std::size_t number : with_damage) {  // read once more, to name the jobs
    const std::vector<std::string> lines = survey(others[number]).counts.damaged;
    damaged.insert(damaged.end(), lines.begin(), lines.end());
  }
  return damaged;
}

BatchReport run_batch(const std::string& manifest, const BatchOptions& options) {
  return run_batch(read_manifest(manifest), options);
}

}  // namespace lober
