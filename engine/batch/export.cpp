#include "engine/batch/export.hpp"

#include <array>

#include "engine/batch/export_row.hpp"

namespace lober {
namespace {

// The result as its operation writes it; none for one that is damaged.
std::optional<StoredResult> sound_result(const Store& store, const PlannedGroup& group, const Store::Known& known,
                                         Record& record) {
  std::optional<StoredResult> result = store.result(known);
  if (!result || result->failed) return result;
  try {
    record = decode(result->value);
  } catch (const DataError&) {
    return std::nullopt;
  }
  const Operation* const operation = find_operation(group.operation);
  const bool whole = operation == nullptr || (record.values.size() == operation->columns.size() &&
                                              record.lists.size() == operation->lists.size());
  return whole ? std::move(result) : std::nullopt;
}

// Goes through the jobs of the plan that are wanted and calls found(number, result, record) for each that has a result.
template <typename Wanted, typename Found>
ExportCounts for_each_result(const Store& store, const Plan& plan, const Wanted& wanted, const Found& found) {
  ExportCounts counts;
  const InputDigests inputs = store.digests();
  std::vector<const std::string*> digests;
  for (const PlannedCurve& curve : plan.curves) {
    const auto at = inputs.find(input_name(curve));
    digests.push_back(at == inputs.end() ? nullptr : &at->second);
  }
  const JobKeys keys(plan);
  for (std::size_t number = 0; number < plan.jobs.size(); ++number) {
    const PlannedJob& job = plan.jobs[number];
    const PlannedGroup& group = plan.groups[job.group];
    if (!wanted(group)) continue;
    static const std::string none;
    std::array<const std::string*, 2> of_curves{&none, &none};
    for (std::size_t k = 0; k < job.curves().size(); ++k) of_curves[k] = digests[job.curves()[k]];
    const auto& [first, second] = of_curves;
    const auto at =
        first != nullptr && second != nullptr ? store.stored().find(keys(job, *first, *second)) : store.stored().end();
    if (at == store.stored().end()) {
      ++counts.missing;
      continue;
    }
    Record record;
    std::optional<StoredResult> result = sound_result(store, group, at->second, record);
    if (!result) {
      ++counts.missing;
      counts.damaged.push_back(damage_line(store, plan, number));
      continue;
    }
    ++(result->failed ? counts.failed : counts.done);
    found(number, std::move(*result), std::move(record));
  }
  if (store.damaged()) counts.damaged.push_back(store.path() + ": is damaged, some of its results cannot be reached");
  return counts;
}

// "FIRST SECOND", or the options of a job without curves.
std::string inputs_of(const Plan& plan, const PlannedJob& job) {
  std::string inputs;
  for (const CurveId id : job.curves()) inputs += (inputs.empty() ? "" : " ") + plan.name(id);
  return inputs.empty() ? plan.groups[job.group].to_string() : inputs;
}

Plan plan_of(const Store& store) {
  std::optional<Plan> plan = store.plan();
  if (!plan) throw DataError("the store holds no plan yet");
  return std::move(*plan);
}

// The operation of a table: the one that is named, or the only one.
const Operation& operation_for(const Plan& plan, const std::optional<std::string>& name) {
  const PlannedGroup* only = nullptr;
  for (const PlannedGroup& group : plan.groups) {
    if (name && group.operation != *name) continue;
    if (only != nullptr && only->operation != group.operation) {
      throw UsageError("the plan has several operations, choose one of them, or JSON lines");
    }
    only = &group;
  }
  if (only == nullptr) throw UsageError("the plan has no operation " + name.value_or(""));
  return operation_of(*only);
}

}  // namespace

ExportFormat export_format(const std::string& path) {
  if (path.ends_with(".csv")) return ExportFormat::csv;
  if (path.ends_with(".jsonl")) return ExportFormat::json_lines;
  if (path.ends_with(".npy")) return ExportFormat::npy;
  throw UsageError(path + ": the name has to end in .csv, .jsonl or .npy");
}

ExportCounts export_results(const Store& store, const std::string& path, ExportFormat format,
                            const std::optional<std::string>& operation) {
  const Plan plan = plan_of(store);
  ExportCounts counts;
  const auto wanted = [&](const PlannedGroup& group) { return !operation || group.operation == *operation; };
  const EachRow rows = [&](const std::function<void(const ExportRow&)>& take) {
    counts = for_each_result(store, plan, wanted, [&](std::size_t number, StoredResult result, Record record) {
      const PlannedJob& job = plan.jobs[number];
      ExportRow row{number, &plan.groups[job.group], plan.name(job.first), plan.name(job.second), result.failed, "",
                    {}};
      if (result.failed) {
        row.message = std::move(result.value);
      } else {
        row.record = std::move(record);
      }
      take(row);
    });
  };
  OutputFile file(path);
  if (format == ExportFormat::json_lines) {
    write_json_lines(file, rows);
  } else if (format == ExportFormat::csv) {
    write_csv(file, operation_for(plan, operation), rows);
  } else {
    write_npy_table(file, operation_for(plan, operation), rows);
  }
  file.commit();
  return counts;
}

StoreSurvey survey(const Store& store) {
  const Plan plan = plan_of(store);
  StoreSurvey all;
  const auto any = [](const PlannedGroup&) { return true; };
  all.counts = for_each_result(store, plan, any, [&](std::size_t number, const StoredResult& result, const Record&) {
    if (result.failed) all.failures.push_back(inputs_of(plan, plan.jobs[number]) + ": " + result.value);
  });
  return all;
}

std::string damage_line(const Store& store, const Plan& plan, std::size_t job) {
  return store.path() + ": the result of job " + std::to_string(job) + " (" + inputs_of(plan, plan.jobs[job]) +
         ") is damaged and counts as missing";
}

ExportCounts export_results(const std::string& store, const std::string& path, ExportFormat format,
                            const std::optional<std::string>& operation) {
  return export_results(Store::open(store), path, format, operation);
}

}  // namespace lober
