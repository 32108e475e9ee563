#include "cli/schema/reference.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <span>
#include <string_view>

#include "cli/program/operation_command.hpp"

namespace lober::cli {
namespace {

using operations::Field;
using operations::FieldKind;
using operations::InputKind;
using operations::OptionSpec;

// Text as a cell of a table may hold it.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string kind_text(InputKind kind) {
  switch (kind) {
    case InputKind::closed_curve:
      return "closed curve";
    case InputKind::open_curve:
      return "open curve";
    case InputKind::curve:
      return "curve";
    case InputKind::points:
      return "points";
    case InputKind::system:
      break;
  }
  return "system";
}

// In the order of the alternatives of OptionValue.
std::string type_text(const OptionSpec& spec) {
  constexpr const char* names[] = {"true or false", "whole number",   "number", "text",
                                   "x, y",          "x0, y0, x1, y1", "numbers"};
  return names[spec.fallback.index()];
}

std::string values_text(const OptionSpec& spec) {
  if (!spec.choices.empty()) return fmt::format("`{}`", fmt::join(spec.choices, "`, `"));
  std::string text = type_text(spec);
  const bool low = std::isfinite(spec.min), high = std::isfinite(spec.max);
  if (low && high && !spec.above_min) return text + fmt::format(" from {:.15g} to {:.15g}", spec.min, spec.max);
  if (low) text += fmt::format("{} {:.15g}", spec.above_min ? " above" : " from", spec.min);
  if (low && !spec.above_min && !high) text += " on";
  if (high) text += fmt::format(" to {:.15g}", spec.max);
  return text;
}

// The text for the value without the option.
std::string default_text(const OptionSpec& spec) {
  if (spec.required) return "has to be given";
  if (spec.optional) return spec.otherwise;
  const std::string value = operations::to_string(spec.fallback);
  return value.empty() ? "" : "`" + value + "`";
}

std::string field_type(const Field& field) {
  switch (field.kind) {
    case FieldKind::number:
      return field.bar.empty() ? "number" : "number, bar `" + field.bar + "`";
    case FieldKind::whole:
      return "whole number";
    case FieldKind::flag:
      return "true or false";
    case FieldKind::text:
      return "text";
    case FieldKind::lines:
      return "texts";
    case FieldKind::numbers:
      return "numbers";
    case FieldKind::wholes:
      return "whole numbers";
    case FieldKind::point:
      return "x, y";
    case FieldKind::matrix:
      return field.bar.empty() ? "matrix" : "matrix, bars `" + field.bar + "`";
    case FieldKind::object:
      return "object";
    case FieldKind::list:
      return "list";
    case FieldKind::points:
      break;
  }
  return "points";
}

void add_fields(std::string& text, std::span<const Field> fields, const std::string& prefix) {
  for (const Field& field : fields) {
    const std::string path = prefix + field.name;
    text += fmt::format("| `{}` | {} | {} | {} |\n", path, field_type(field), field.unit, cell(field.meaning));
    add_fields(text, field.members, path + (field.kind == FieldKind::list ? "[]." : "."));
  }
}

}  // namespace

std::string reference_text(const operations::Operation& operation) {
  std::string text =
      fmt::format("## {}\n\n{}\n\n```usage\n{}\n```\n", operation.name, operation.summary, call_of(operation));
  text += "\n| input | kind | |\n|---|---|---|\n";
  for (const operations::InputSpec& input : operation.inputs) {
    text += fmt::format("| `{}` | {}{} | {} |\n", input.name, kind_text(input.kind),
                        input.optional ? ", may be left out" : "", cell(input.meaning));
  }
  text += "\n| option | values | without it | |\n|---|---|---|---|\n";
  for (const OptionSpec& spec : operation.options) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", spec.key, values_text(spec), cell(default_text(spec)),
                        cell(spec.meaning));
  }
  text += "\n| result | | unit | |\n|---|---|---|---|\n";
  add_fields(text, operation.result, "");
  return text;
}

}  // namespace lober::cli
