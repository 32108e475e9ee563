#include "engine/batch/shared_run.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>

#include "engine/batch/operations/result.hpp"
#include "engine/batch/plan_outputs.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Its jobs are numbered as they stand in `jobs`, groups and curves anew.
Plan portion_of(const Plan& plan, std::span<const std::uint32_t> jobs) {
  Plan portion;
  std::unordered_map<std::uint32_t, std::uint32_t> groups, curves;
  const auto number_in = [](auto& numbers, auto& list, std::uint32_t number, const auto& all) {
    const auto [at, is_new] = numbers.try_emplace(number, static_cast<std::uint32_t>(list.size()));
    if (is_new) list.push_back(all[number]);
    return at->second;
  };
  const auto curve = [&](CurveId id) {
    return id == no_curve ? no_curve : number_in(curves, portion.curves, id, plan.curves);
  };
  portion.jobs.reserve(jobs.size());
  for (const std::uint32_t number : jobs) {
    const Job& job = plan.jobs[number];
    const std::uint32_t group = number_in(groups, portion.groups, job.group, plan.groups);
    const CurveId first = curve(job.first);
    portion.jobs.push_back({group, first, curve(job.second)});
  }
  return portion;
}

std::string with_names(std::string text, const std::vector<std::pair<std::string, std::string>>& names) {
  for (std::size_t at = 0; at < text.size();) {
    const auto fits = [&](const auto& name) {
      return !name.first.empty() && text.compare(at, name.first.size(), name.first) == 0;
    };
    const auto name = std::find_if(names.begin(), names.end(), fits);
    if (name == names.end()) {
      ++at;
    } else {
      text.replace(at, name->first.size(), name->second);
      at += name->second.size();
    }
  }
  return text;
}

}  // namespace

SharedRun::SharedRun(Manifest manifest, const BatchOptions& options)
    : manifest_(std::move(manifest)), plan_(make_plan(manifest_)), keys_(plan_) {
  accept_outputs(output_folder_of(options.output_root, manifest_.path, plan_, options.store), manifest_.path, plan_);
  (void)jobs_of(plan_, options.shard);  // refused before there is a store
  session_ = std::make_unique<StoreSession>(options.store, plan_, manifest_, options.shard, options.queue.threads,
                                            [this] { broken_ = true; });
  queue_.emplace(plan_, manifest_.path, session_->pending());
  report_.jobs = session_->pending().size() + session_->finished_before();
  report_.finished_before = session_->finished_before();
  report_.damaged = session_->damaged();
  report_.hidden = session_->hidden();
}

SharedRun::~SharedRun() = default;

std::string SharedRun::encoded(std::span<const std::uint32_t> jobs) const {
  return portion_of(plan_, jobs).encoded();
}

std::vector<std::string> SharedRun::files(std::span<const std::uint32_t> jobs) const {
  std::set<CurveId> curves;
  for (const std::uint32_t job : jobs) {
    for (const CurveId id : plan_.jobs[job].curves()) curves.insert(id);
  }
  std::set<std::string> files;
  for (const CurveId id : curves) {
    if (!plan_.curves[id].file.empty()) files.insert(plan_.curves[id].file);
  }
  return {files.begin(), files.end()};
}

bool SharedRun::has_outputs() const {
  return std::any_of(plan_.jobs.begin(), plan_.jobs.end(),
                     [&](const Job& job) { return !plan_.output_of(job).empty(); });
}

void SharedRun::add(std::span<const std::uint32_t> jobs, std::string_view results) {
  DecodedResults decoded = decoded_results(results);
  std::vector<char> seen(jobs.size(), 0);
  const bool whole = decoded.results.size() == jobs.size() &&
                     std::all_of(decoded.results.begin(), decoded.results.end(), [&](const Result& result) {
                       return result.job < jobs.size() && std::exchange(seen[result.job], 1) == 0;
                     });
  if (!whole) throw DataError("the bytes that came back are not the results of their jobs");
  for (Result& result : decoded.results) {
    result.job = jobs[result.job];
    take(std::move(result));
  }
}

void SharedRun::fail(std::uint32_t job, const std::string& message) {
  Result result;
  result.job = job;
  result.error = message;
  const CurvePair curves = plan_.jobs[job].curves();
  std::array<std::string, 2> digests;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    try {
      digests[k] = digests_of({plan_.curves[curves[k]]}, manifest_.path).at(0);
      result.digests[k] = digests[k];
    } catch (const DataError&) {  // an input that cannot be read has none
    }
  }
  take(std::move(result));
}

void SharedRun::take(Result&& result) {
  const bool failed = result.failed();
  // A failure without its inputs goes by the names, and those are the names of this plan.
  if (failed) result.key = keys_(plan_.jobs[result.job], result.digests[0], result.digests[1]);
  ++report_.queue.jobs;
  if (!session_->add(std::move(result)) || failed) ++report_.queue.failed;
  if (broken_) finish("broken off by a failure");  // which throws the reason
}

void SharedRun::finish(const std::string& how) {
  report_.store_seconds = session_->finish(how);
  report_.stored_meanwhile = session_->stored_meanwhile();
  report_.queue.stopped = report_.queue.jobs < pending();
}

PortionResults run_portion(std::string_view portion, const PortionOptions& options) {
  Plan plan = Plan::decoded(portion);
  for (CurveSource& curve : plan.curves) {
    if (std::filesystem::path(curve.file).is_absolute()) curve.file = options.files_root + curve.file;
  }
  const OutputFolder outputs = output_folder_of(options.output_root, options.manifest_path, plan, options.store);
  const std::vector<std::uint32_t> jobs = jobs_of(plan, {});
  PlanRunner runner(plan, options.manifest_path, jobs, options.queue, &outputs, options.kept);
  std::vector<Result> results;
  results.reserve(jobs.size());
  PortionResults done;
  done.queue = runner.run(jobs, [&](Result&& result) {
    result.error = with_names(std::move(result.error), options.names);
    results.push_back(std::move(result));
  });
  for (std::string& line : done.queue.warnings) line = with_names(std::move(line), options.names);
  done.results = encoded(results);
  return done;
}

}  // namespace lober::detail
