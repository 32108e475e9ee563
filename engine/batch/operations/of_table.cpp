#include "engine/batch/operations/of_table.hpp"

#include <algorithm>

#include "engine/base/text.hpp"
#include "engine/batch/operations/named_system.hpp"
#include "engine/batch/operations/output_folder.hpp"
#include "engine/batch/operations/output_name.hpp"
#include "engine/batch/operations/result_numbers.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

operations::SystemInput system_input_of(const Options& options, double integration_tolerance) {
  IntegrationOptions integration;
  integration.tolerance = integration_tolerance;
  require_for_manifests(options.text("system"));
  return operations::system_input(options.text("system"), options.reals_of("parameters"), integration);
}

// Wrong options of the system are refused before the first job; a member of a grid that has no tangle fails alone.
void check_system(const Options& options, bool needs_tangle) {
  try {
    const System system = system_of(options.text("system"), options.reals_of("parameters"), 1e-12);
    if (needs_tangle && !system.connection && system.no_connection.empty() && options.find("from") == nullptr)
      throw UsageError(options.text("system") + " names no manifolds of interest");
  } catch (const UsageError& error) {
    throw UsageError(std::string("system: ") + error.what());
  }
}

bool is_on_system(const operations::Operation& entry) {
  return entry.inputs.front().kind == operations::InputKind::system;
}

bool has_option(const operations::Operation& entry, std::string_view key) {
  return std::any_of(entry.options.begin(), entry.options.end(),
                     [key](const OptionSpec& one) { return one.key == key; });
}

// The requirements that jobs of an operation may have; their options take some of them back.
Requirements possible_requirements(const operations::Operation& entry) {
  using Kind = operations::InputKind;
  Requirements wanted;
  if (is_on_system(entry) || entry.inputs.front().kind == Kind::curve) return wanted;
  wanted.index = true;
  wanted.closed = entry.inputs.front().kind == Kind::closed_curve;
  wanted.simple = has_option(entry, "check_simple");
  wanted.discretisation = has_option(entry, "discretisation");
  return wanted;
}

Requirements requirements_of(Requirements wanted, const Options& options) {
  wanted.simple = wanted.simple && options.flag("check_simple");
  wanted.discretisation = wanted.discretisation && options.flag("discretisation");
  return wanted;
}

std::vector<operations::Input> inputs_of(const operations::Operation& entry, const Requirements& possible,
                                         const JobCurves& curves, const Options& options) {
  if (is_on_system(entry)) return {system_input_of(options, options.real("integration_tolerance"))};
  const Requirements known = requirements_of(possible, options);
  std::vector<operations::Input> inputs;
  inputs.reserve(curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const PreparedCurve& one = *curves[k];
    if (entry.inputs[k].kind == operations::InputKind::points) {
      inputs.emplace_back(std::span<const Point>(one.curve().points));
    } else {
      inputs.emplace_back(operations::CurveInput{one.curve(), one.curve().name, known.index ? &one.index() : nullptr,
                                                 known.discretisation ? &one.sums() : nullptr, known.simple});
    }
  }
  return inputs;
}

std::string output_of(const Options& options, std::string_view first, std::string_view second) {
  std::string name = output_name(options.text("output"), options, first, second);
  // The file of the curve has given it.
  const std::size_t other = other_ending(name).size();
  return other == 0 ? name : name.replace(name.size() - other, other, ".npy");
}

void write_output(const JobCurves& curves, const Options& options, std::span<const Point> points) {
  if (options.text("output").empty()) return;
  const std::string name =
      output_of(options, curves[0]->curve().name, curves.size() > 1 ? curves[1]->curve().name : std::string_view());
  write_npy(curves.outputs() != nullptr ? curves.outputs()->accept(name) : name, points);
}

// The operation that a job runs, with the paths to its numbers.
struct Runner {
  const operations::Operation* entry;
  Requirements possible;
  ResultNumbers columns;
  std::vector<operations::NumberPath> lists;
  std::string lists_if;  // the option that asks for the lists
  std::function<std::span<const Point>(const operations::Outcome&)> points;

  Result operator()(const JobCurves& curves, const Options& options) const {
    operations::Context context;
    context.memory = curves.allowance().most();
    context.progress = [&](double, const std::string&) {
      curves.allowance().check();
      return true;
    };
    context.holds = [&](std::size_t bytes) { curves.allowance().book(bytes); };
    context.on_part = [](const void*) {};  // orbits, which would be kept where nobody takes them
    const operations::Outcome found = entry->run(inputs_of(*entry, possible, curves, options), options, context);
    if (const auto apart = found.agreement.disagreements(); !apart.empty()) {
      throw DataError("two routes disagree: " + apart.front().what + " by " + apart.front().first_by + " and by " +
                      apart.front().second_by + " differ by " + format_number(apart.front().difference()) +
                      ", more than their error bars " + format_number(apart.front().bar));
    }
    if (!found.incomplete.empty()) throw DataError(found.incomplete);
    if (points) write_output(curves, options, points(found));
    Result record;
    record.values = columns(found.value.get());
    if (!lists_if.empty() && !options.flag(lists_if)) return record;
    for (const operations::NumberPath& path : lists) record.lists.push_back(path.all(found.value.get()));
    return record;
  }
};

// A name that ends as another format does would be that of a file which nobody can read.
void require_npy(std::string_view output) {
  const std::string_view ending = other_ending(output);
  if (ending.empty()) return;
  throw UsageError("output: " + std::string(output) + " ends in " + std::string(ending) +
                   ", but the curve is written in NPY");
}

// Throws for a path that leads to no numbers: what has been renamed is seen before the first job.
Column::Kind kind_at(const operations::Field& field, const std::string& name) {
  using Kind = operations::FieldKind;
  const bool is_whole = field.kind == Kind::whole || field.kind == Kind::flag;
  if (is_whole && !field.null) return Column::Kind::count;
  if (is_whole || field.kind == Kind::number) return Column::Kind::real;
  throw UsageError("a column of a batch has no numbers: " + name);
}

// The paths of all numbers, with their bars; those of lists apart, and none of lists within lists.
void add_numbers(std::span<const operations::Field> fields, const std::string& prefix, TableJob::Names& columns,
                 TableJob::Names* lists) {
  using Kind = operations::FieldKind;
  const auto add = [&](const std::string& path) {
    std::string name = path;
    std::replace(name.begin(), name.end(), '.', '_');
    columns.emplace_back(std::move(name), path);
  };
  for (const operations::Field& field : fields) {
    const std::string path = prefix + field.name;
    if (field.kind == Kind::object) {
      add_numbers(field.members, path + ".", columns, lists);
    } else if (field.kind == Kind::list) {
      if (lists != nullptr) add_numbers(field.members, path + ".", *lists, nullptr);
    } else if (field.kind == Kind::number || field.kind == Kind::whole || field.kind == Kind::flag) {
      add(path);
      if (!field.bar.empty()) add(prefix + field.bar);
    }
  }
}

Arity arity_of(const operations::Operation& entry) {
  if (is_on_system(entry)) return Arity::none;
  if (entry.inputs.size() == 1) return Arity::one;
  return entry.inputs.back().optional ? Arity::one_or_two : Arity::two;
}

void add_system_options(std::vector<OptionSpec>& options) {
  options.push_back({"system", "", "name of the system"});
  options.push_back({"parameters.*", 0.0, "parameters of the system, by name; those left out take their defaults"});
  options.push_back({"integration_tolerance",
                     IntegrationOptions{}.tolerance,
                     "error of a step of the integration of a flow",
                     {},
                     1e-16,
                     1e-2});
}

}  // namespace

Operation operation_of(const operations::Operation& entry, const TableJob& job) {
  Operation operation;
  operation.name = entry.name;
  operation.summary = entry.title;
  operation.revision = entry.revision;
  operation.view = job.view;
  operation.not_kept = job.not_kept;
  operation.arity = arity_of(entry);
  operation.open = entry.inputs.front().kind == operations::InputKind::open_curve;
  if (is_on_system(entry)) add_system_options(operation.options);
  operation.options.insert(operation.options.end(), entry.options.begin(), entry.options.end());
  if (job.lists_if) operation.options.push_back(*job.lists_if);
  // Options are read one by one: whether those are there that have to be is looked at when all are known.
  std::vector<OptionSpec> required;
  for (OptionSpec& spec : operation.options) {
    if (!spec.required) continue;
    required.push_back(spec);
    spec.required = false;
  }
  if (job.points) {
    operation.options.push_back(
        {"output", "",
         "file for the curve, in NPY, below the folder of the manifest; {name} and {second} stand for the names of the "
         "curves given, without the ending of another format where more follows, {max_length} and the like for "
         "options; empty: no file"});
    operation.output = output_of;
  }
  const Requirements possible = possible_requirements(entry);
  Runner runner{&entry, possible, ResultNumbers(entry.result), {}, job.lists_if ? job.lists_if->key : "", job.points};
  for (const auto& [name, path] : job.columns) {
    const operations::Field& at = runner.columns.add(path);
    operation.columns.push_back({name, kind_at(at, name), at.unit, at.meaning});
  }
  for (const auto& [name, path] : job.lists) {
    (void)kind_at(runner.lists.emplace_back(entry.result, path).field(), name);
    operation.lists.push_back(name);
  }
  operation.check = [&entry, required, on_system = is_on_system(entry), needs_tangle = job.needs_tangle,
                     has_output = static_cast<bool>(job.points), not_kept = job.not_kept,
                     reason = reason_not_kept(operation)](const Options& options) {
    for (const std::string& key : not_kept) {
      if (options.flag(key)) throw UsageError(std::string(key).append(": ").append(reason));
    }
    for (const OptionSpec& spec : required) {
      if (options.find(spec.key) == nullptr) throw UsageError(spec.key + ": is missing: the " + spec.meaning);
    }
    if (on_system) check_system(options, needs_tangle);
    if (entry.check) entry.check(options, on_system ? 1 : entry.inputs.size());
    if (has_output) require_npy(options.text("output"));
  };
  operation.requirements = [possible](const Options& options) { return requirements_of(possible, options); };
  operation.run = std::move(runner);
  operation.cost = [constant = job.microseconds, rate = job.microseconds_a_point](std::size_t points) {
    return constant + rate * static_cast<double>(points);
  };
  operation.memory = job.memory;
  if (entry.result_bytes) {
    operation.result_bytes = [&entry](const Curve& curve, const Options& options) {
      return entry.result_bytes(operations::CurveInput{curve, curve.name}, options);
    };
  }
  return operation;
}

TableJob job_as_described(const operations::Operation& entry) {
  TableJob job;
  job.view = entry.name + "s";
  job.needs_tangle = false;
  job.microseconds = 1e5;
  job.microseconds_a_point = 1;
  add_numbers(entry.result, "", job.columns, &job.lists);
  return job;
}

void add_areas(TableJob::Names& columns, const std::string& prefix, const std::string& path) {
  for (const char* const area :
       {"c1", "c2", "intersection", "union", "c1_minus_c2", "c2_minus_c1", "symmetric_difference"}) {
    columns.emplace_back(prefix + area, path + "." + area);
  }
}

void add_all(TableJob::Names& columns, const TableJob::Names& more) {
  columns.insert(columns.end(), more.begin(), more.end());
}

}  // namespace lober::detail
