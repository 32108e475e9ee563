// The table of operations as users see it (lober/batch.hpp).
#include <array>
#include <cmath>

#include "engine/batch/operations/operation.hpp"
#include "lober/batch.hpp"

namespace lober {
using namespace detail;
namespace {

const char* type_of(const OptionValue& value) {
  constexpr std::array names{"true or false", "whole number",         "number",         "text",
                             "point [x, y]",  "box [x0, y0, x1, y1]", "list of numbers"};
  return names.at(value.index());
}

std::optional<double> bound(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

OperationOption described(const OptionSpec& spec) {
  return {spec.key,
          type_of(spec.fallback),
          spec.family() || spec.optional ? spec.otherwise : to_string(spec.fallback),
          spec.choices,
          bound(spec.min),
          bound(spec.max),
          spec.above_min,
          spec.meaning};
}

OperationInfo described(const Operation& operation) {
  OperationInfo info;
  info.name = operation.name;
  info.summary = operation.summary;
  info.min_curves = takes(operation.arity, 0) ? 0 : takes(operation.arity, 1) ? 1 : 2;
  info.max_curves = takes(operation.arity, 2) ? 2 : info.min_curves;
  info.open = operation.open;
  info.view = operation.view;
  for (const OptionSpec& spec : operation.options) {
    if (operation.keeps(spec.key)) info.options.push_back(described(spec));
  }
  for (const Column& column : operation.columns) info.columns.push_back(column.name);
  info.lists = operation.lists;
  return info;
}

}  // namespace

std::vector<OperationInfo> list_operations() {
  std::vector<OperationInfo> list;
  for (const Operation& operation : all_operations()) list.push_back(described(operation));
  return list;
}

}  // namespace lober
