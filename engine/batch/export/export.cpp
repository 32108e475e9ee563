#include "engine/batch/export/export.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "engine/base/nearest_word.hpp"
#include "engine/batch/export/export_formats.hpp"
#include "engine/batch/manifest/swept_options.hpp"
#include "lober/base/cancellation.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::uint32_t jobs_between_reports = 64;

// "FIRST SECOND parameters.K=0.9": the curves and what a grid varies, or else all options of a job without curves.
std::string inputs_of(const Plan& plan, const Job& job, const std::vector<SweptOption>& swept) {
  const JobGroup& group = plan.group_of(job);
  std::string inputs;
  for (const CurveId id : job.curves()) inputs += (inputs.empty() ? "" : " ") + plan.name(id);
  const std::string values = swept_values(swept, group);
  if (!values.empty()) inputs += (inputs.empty() ? "" : " ") + values;
  return inputs.empty() ? group.options.to_string() : inputs;
}

// Compares files, not names: the table of a batch must not replace one of its curves under any name.
void require_no_curve(const std::string& path, const Store& store, const Plan& plan) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (path == "-" || !fs::exists(path, ignored)) return;
  // Where the curves were, or are now if the batch was moved.
  std::set<fs::path> folders{"", fs::path(store.path()).parent_path()};
  for (const Store::Run& run : store.runs()) folders.insert(run.folder);
  std::set<std::string_view> done;
  for (const CurveSource& curve : plan.curves) {
    if (curve.file.empty() || !done.insert(curve.file).second) continue;
    for (const fs::path& folder : folders) {
      if (fs::equivalent(folder / curve.file, path, ignored)) {
        throw UsageError(path + ": is " + curve.file + ", a curve of this batch; name another file");
      }
    }
  }
}

// The operation of a table: the one that is named, or the only one.
const Operation& operation_for(const Plan& plan, const std::optional<std::string>& name) {
  std::vector<const Operation*> all;
  std::vector<std::string> names;
  for (const JobGroup& group : plan.groups) {
    if (std::find(all.begin(), all.end(), group.operation) != all.end()) continue;
    all.push_back(group.operation);
    names.push_back(group.operation->name);
  }
  if (name) {
    const auto found = std::find(names.begin(), names.end(), *name);
    if (found != names.end()) return *all[static_cast<std::size_t>(found - names.begin())];
    throw UsageError("the plan has no operation " + *name + "; it has " + joined(names) + did_you_mean(*name, names));
  }
  if (all.size() == 1) return *all.front();
  throw UsageError("the plan has several operations; choose one of " + joined(names) +
                   " by the option \"operation\", or JSON lines, which hold all");
}

}  // namespace

SpreadTable detail::spread_table(const Operation& operation, const EachResult& results) {
  SpreadTable table{operation, results};
  if (!operation.spread) return table;
  std::map<std::string, std::size_t> positions;
  results([&](const Result& result) {
    if (result.failed()) return;
    for (auto& [column, value] : operation.spread(result)) {
      if (positions.emplace(column.name, table.operation.columns.size()).second) {
        table.operation.columns.push_back(std::move(column));
      }
    }
  });
  table.results = [columns = table.operation.columns.size(), positions = std::move(positions), &operation,
                   results](const std::function<void(const Result&)>& take) {
    results([&](const Result& result) {
      if (result.failed()) return take(result);
      Result spread = result;
      spread.values.resize(columns, std::numeric_limits<double>::quiet_NaN());
      for (const auto& [column, value] : operation.spread(result)) spread.values[positions.at(column.name)] = value;
      take(spread);
    });
  };
  return table;
}

ExportFormat export_format(const std::string& path) {
  if (path.ends_with(".csv")) return ExportFormat::csv;
  if (path.ends_with(".jsonl")) return ExportFormat::json_lines;
  if (path.ends_with(".npy")) return ExportFormat::npy;
  if (path.ends_with(".nc")) return ExportFormat::netcdf;
  if (path.ends_with(".h5") || path.ends_with(".hdf5")) return ExportFormat::hdf5;
  throw UsageError(path + ": the name has to end in .csv, .jsonl, .npy, .nc or .h5");
}

Plan detail::plan_of(const Store& store) {
  std::optional<Plan> plan = store.plan();
  if (!plan) throw DataError("the store holds no plan yet");
  return std::move(*plan);
}

ExportCounts detail::for_each_result(const Store& store, const Plan& plan, const std::optional<std::string>& operation,
                                     const std::function<void(const Result&)>& found, const Progress& progress) {
  ExportCounts counts;
  const InputDigests inputs = store.digests();
  const std::vector<const std::string*> digests = digests_by_curve(plan, inputs);
  const JobKeys keys(plan);
  for (std::uint32_t number = 0; number < plan.jobs.size(); ++number) {
    if (number % jobs_between_reports == 0 &&
        !progress(static_cast<double>(number) / static_cast<double>(plan.jobs.size()))) {
      throw Cancelled();
    }
    const Job& job = plan.jobs[number];
    if (operation && plan.group_of(job).operation->name != *operation) continue;
    const std::optional<JobKey> key = keys.find(job, digests);
    const Store::Known* const known = key ? store.stored().find(*key) : nullptr;
    if (known == nullptr) {
      ++counts.missing;
      continue;
    }
    std::optional<Result> result = store.result(*known);
    if (!result) {
      ++counts.missing;
      counts.damaged.push_back(damage_line(store, plan, number));
      continue;
    }
    ++(result->failed() ? counts.failed : counts.done);
    result->job = number;
    found(*result);
  }
  if (store.damaged()) counts.damaged.push_back(store.path() + ": is damaged, some of its results cannot be reached");
  return counts;
}

ExportCounts detail::export_results(const Store& store, const std::string& path, ExportFormat format,
                                    const std::optional<std::string>& operation, const Progress& progress) {
  const Plan plan = plan_of(store);
  ExportCounts counts;
  // Tables of fixed columns go through the results twice, first for the widths of texts and which columns there are.
  const bool lines = format == ExportFormat::json_lines;
  const Operation* const of_table = lines ? nullptr : &operation_for(plan, operation);
  if (lines && operation) (void)operation_for(plan, operation);  // refused where the plan does not have it
  const double passes = (lines || format == ExportFormat::csv ? 1 : 2) + (of_table && of_table->spread ? 1 : 0);
  double pass = 0;
  const EachResult results = [&](const std::function<void(const Result&)>& take) {
    const Progress share([&](double part) { return progress((pass + part) / passes); });
    counts = for_each_result(store, plan, operation, take, share);
    pass = std::min(pass + 1, passes - 1);
  };
  require_no_curve(path, store, plan);
  OutputFile file(path);
  if (lines) {
    write_json_lines(file, plan, results);
  } else {
    const SpreadTable table = spread_table(*of_table, results);
    const auto write = format == ExportFormat::csv      ? write_csv
                       : format == ExportFormat::netcdf ? write_netcdf
                       : format == ExportFormat::hdf5   ? write_hdf5
                                                        : write_npy_table;
    write(file, plan, table.operation, table.results);
  }
  file.commit();
  return counts;
}

StoreSurvey detail::survey(const Store& store, const Progress& progress) {
  const Plan plan = plan_of(store);
  StoreSurvey all;
  std::map<std::string, std::size_t> known;  // failures, by message
  std::map<const Operation*, std::vector<SweptOption>> swept;
  const auto first_of = [&](const Result& result) {
    const Job& job = plan.jobs[result.job];
    const Operation* const operation = plan.group_of(job).operation;
    const auto [at, is_new] = swept.try_emplace(operation);
    if (is_new) at->second = swept_options(plan, *operation);
    return inputs_of(plan, job, at->second);
  };
  const auto note = [&](const Result& result) {
    if (!result.failed()) return;
    const auto [at, is_new] = known.try_emplace(result.error, all.failures.size());
    if (is_new) all.failures.push_back({result.error, first_of(result)});
    ++all.failures[at->second].jobs;
  };
  all.counts = for_each_result(store, plan, {}, note, progress);
  return all;
}

std::string detail::damage_line(const Store& store, const Plan& plan, std::size_t job) {
  const std::vector<SweptOption> swept = swept_options(plan, *plan.group_of(plan.jobs[job]).operation);
  return store.path() + ": the result of job " + std::to_string(job) + " (" + inputs_of(plan, plan.jobs[job], swept) +
         ") is damaged and counts as missing";
}

ExportCounts export_results(const std::string& store, const std::string& path, ExportFormat format,
                            const std::optional<std::string>& operation) {
  return export_results(Store::open(store), path, format, operation);
}

}  // namespace lober
