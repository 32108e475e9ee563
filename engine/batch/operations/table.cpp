// All operations. One that a batch has to know more of than its description is a file beside this one and a line in the
// list below; the others follow from the engine's table.
#include "engine/batch/operations/table.hpp"

#include <algorithm>
#include <vector>

#include "engine/base/nearest_word.hpp"
#include "engine/batch/operations/of_table.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

std::vector<Operation> every_operation() {
  std::vector<Operation> table{
      overlay_operation(),      interior_operation(),        regions_operation(), winding_operation(),
      tangle_operation(),       manifold_tangle_operation(), densify_operation(), simplify_operation(),
      transport_operation(),    curve_transport_operation(), sweep_operation(),   escape_operation(),
      fixed_points_operation(), levels_operation(),          section_operation(), grow_operation()};
  for (const operations::Operation& entry : operations::all()) {
    if (std::any_of(table.begin(), table.end(), [&](const Operation& any) { return any.name == entry.name; })) continue;
    table.push_back(operation_of(entry, job_as_described(entry)));
  }
  return table;
}

}  // namespace

std::span<const Operation> all_operations() {
  static const std::vector<Operation> table = every_operation();
  return table;
}

bool takes(Arity arity, std::size_t curves) {
  switch (arity) {
    case Arity::none:
      return curves == 0;
    case Arity::one:
      return curves == 1;
    case Arity::two:
      return curves == 2;
    case Arity::one_or_two:
      return curves == 1 || curves == 2;
  }
  return false;
}

std::string reason_not_kept(const Operation& operation) {
  return "batches keep no numbers of it; lober " + operation.name + " shows them";
}

Options job_options(const Operation& operation, std::span<const OptionSetting> settings) {
  std::vector<std::string> all, kept;
  for (const OptionSpec& spec : operation.options) {
    all.push_back(spec.key);
    if (operation.keeps(spec.key)) kept.push_back(spec.key);
  }
  for (const OptionSetting& setting : settings) {
    if (std::any_of(operation.options.begin(), operation.options.end(),
                    [&](const OptionSpec& spec) { return spec.is_for(setting.key); })) {
      continue;
    }
    const std::string meant = nearest_word(setting.key, all);
    throw UsageError(setting.key + ": there is no such option; there are " + joined(kept) +
                     (operation.keeps(meant) ? did_you_mean(setting.key, kept)
                                             : "; " + meant + " is refused: " + reason_not_kept(operation)));
  }
  return {operation.options, settings};
}

const Operation* find_operation(std::string_view name) {
  const std::span<const Operation> table = all_operations();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Operation& any) { return any.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace lober::detail
