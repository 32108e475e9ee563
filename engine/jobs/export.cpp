#include "engine/jobs/export.hpp"

#include "engine/jobs/export_row.hpp"

namespace lober {
namespace {

// Calls found(number, result) for each job of the plan, with null when there is no result.
template <typename Found>
void for_each_job(const Store& store, const Plan& plan, const Found& found) {
  const InputDigests inputs = store.digests();
  std::vector<const std::string*> digests;
  for (const PlannedCurve& curve : plan.curves) {
    const auto at = inputs.find(input_name(curve));
    digests.push_back(at == inputs.end() ? nullptr : &at->second);
  }
  const JobKeys keys(plan);
  for (std::size_t number = 0; number < plan.jobs.size(); ++number) {
    const PlannedJob& job = plan.jobs[number];
    static const std::string none;
    std::array<const std::string*, 2> of_curves{&none, &none};
    for (std::size_t k = 0; k < job.curves().size(); ++k) of_curves[k] = digests[job.curves()[k]];
    const auto& [first, second] = of_curves;
    const Store::Known* known = nullptr;
    if (first != nullptr && second != nullptr) {
      const auto at = store.known().find(keys(job, *first, *second));
      if (at != store.known().end()) known = &at->second;
    }
    found(number, known);
  }
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
  const EachRow rows = [&](const std::function<void(const ExportRow&)>& take) {
    counts = {};
    for_each_job(store, plan, [&](std::size_t number, const Store::Known* known) {
      const PlannedJob& job = plan.jobs[number];
      const PlannedGroup& group = plan.groups[job.group];
      if (operation && group.operation != *operation) return;
      if (known == nullptr) {
        ++counts.missing;
        return;
      }
      StoredResult result = store.result(*known);
      ++(result.failed ? counts.failed : counts.done);
      ExportRow row{number, &group, plan.name(job.first), plan.name(job.second), result.failed, "", {}};
      if (result.failed) {
        row.message = std::move(result.value);
      } else {
        row.record = decode(result.value);
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

ExportCounts count_results(const Store& store) {
  ExportCounts counts;
  for_each_job(store, plan_of(store), [&](std::size_t, const Store::Known* known) {
    ++(known == nullptr ? counts.missing : known->failed ? counts.failed : counts.done);
  });
  return counts;
}

std::vector<std::string> failures_of(const Store& store) {
  const Plan plan = plan_of(store);
  std::vector<std::string> failures;
  for_each_job(store, plan, [&](std::size_t number, const Store::Known* known) {
    if (known == nullptr || !known->failed) return;
    const PlannedJob& job = plan.jobs[number];
    std::string inputs;
    for (const CurveId id : job.curves()) inputs += (inputs.empty() ? "" : " ") + plan.name(id);
    if (inputs.empty()) inputs = plan.groups[job.group].spelled();
    failures.push_back(inputs + ": " + store.result(*known).value);
  });
  return failures;
}

}  // namespace lober
