#include "engine/batch/operations/of_table.hpp"

#include <array>

#include "engine/base/text.hpp"
#include "engine/batch/operations/named_system.hpp"
#include "lober/error.hpp"

namespace lober::detail {
namespace {

operations::SystemInput system_input_of(const Options& options, double integration_tolerance) {
  IntegrationOptions integration;
  integration.tolerance = integration_tolerance;
  require_for_manifests(options.text("system"));
  return operations::system_input(options.text("system"), options.reals_of("parameters"), integration);
}

// Those of the system are refused before the first job; a member of a grid that has no tangle fails alone.
void check_system(const Options& options, bool needs_tangle) {
  try {
    const System system = system_of(options.text("system"), options.reals_of("parameters"), 1e-12);
    if (needs_tangle && !system.connection && system.no_connection.empty() && options.find("from") == nullptr)
      throw UsageError(options.text("system") + " names no manifolds of interest");
  } catch (const UsageError& error) {
    throw UsageError(std::string("system: ") + error.what());
  }
}

Result run(const operations::Operation& entry, const TableJob& job, const JobCurves& curves, const Options& options) {
  const std::array<operations::Input, 1> inputs{system_input_of(options, options.real("integration_tolerance"))};
  operations::Context context;
  context.memory = curves.allowance().most();
  context.progress = [&](double, const std::string&) {
    curves.allowance().check();
    return true;
  };
  context.on_part = [](const void*) {};  // orbits, which would be kept where nobody takes them
  const operations::Outcome found = entry.run(inputs, options, context);
  if (const auto apart = found.agreement.disagreements(); !apart.empty()) {
    throw DataError("two routes disagree: " + apart.front().what + " by " + apart.front().first_by + " and by " +
                    apart.front().second_by + " differ by " + format_number(apart.front().difference()) +
                    ", more than their error bars " + format_number(apart.front().bar));
  }
  Result record;
  for (const auto& [name, path] : job.columns) {
    record.values.push_back(numbers_at(entry.result, found.value.get(), path).front());
  }
  for (const auto& [name, path] : job.lists) {
    record.lists.push_back(numbers_at(entry.result, found.value.get(), path));
  }
  return record;
}

// Throws for a path that leads to no numbers: what has been renamed is seen before the first job.
Column::Kind kind_at(std::span<const operations::Field> fields, std::string_view path) {
  using Kind = operations::FieldKind;
  const operations::Field& field = field_at(fields, path);
  const bool is_whole = field.kind == Kind::whole || field.kind == Kind::flag;
  if (is_whole && !field.null) return Column::Kind::count;
  if (is_whole || field.kind == Kind::number) return Column::Kind::real;
  throw UsageError("a column of a batch has no numbers at \"" + std::string(path) + "\"");
}

}  // namespace

Operation operation_of(const operations::Operation& entry, const TableJob& job) {
  Operation operation;
  operation.name = entry.name;
  operation.summary = entry.title;
  operation.revision = entry.revision;
  operation.view = job.view;
  operation.arity = Arity::none;
  operation.options = {{"system", "", "name of the system"},
                       {"parameters.*", 0.0, "parameters of the system, by name; those left out take their defaults"},
                       {"integration_tolerance",
                        IntegrationOptions{}.tolerance,
                        "error of a step of the integration of a flow",
                        {},
                        1e-16,
                        1e-2}};
  operation.options.insert(operation.options.end(), entry.options.begin(), entry.options.end());
  // Options are read one by one: whether those are there that have to be is looked at when all are known.
  std::vector<OptionSpec> required;
  for (OptionSpec& spec : operation.options) {
    if (!spec.required) continue;
    required.push_back(spec);
    spec.required = false;
  }
  for (const auto& [name, path] : job.columns) {
    operation.columns.push_back({name, kind_at(entry.result, path)});
  }
  for (const auto& [name, path] : job.lists) {
    (void)kind_at(entry.result, path);
    operation.lists.push_back(name);
  }
  operation.check = [required, needs_tangle = job.needs_tangle](const Options& options) {
    for (const OptionSpec& spec : required) {
      if (options.find(spec.key) == nullptr) throw UsageError(spec.key + ": is missing: the " + spec.meaning);
    }
    check_system(options, needs_tangle);
  };
  operation.requirements = [](const Options&) { return Requirements{}; };
  operation.run = [&entry, job](const JobCurves& curves, const Options& options) {
    return run(entry, job, curves, options);
  };
  operation.cost = [microseconds = job.microseconds](std::size_t) { return microseconds; };
  operation.memory = job.memory;
  return operation;
}

}  // namespace lober::detail
