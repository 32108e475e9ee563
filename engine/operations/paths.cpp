// Numbers of results by their names.
#include <algorithm>
#include <limits>

#include "lober/error.hpp"
#include "lober/operations.hpp"

namespace lober::operations {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(std::span<const Field> fields, std::string_view name) {
  std::string known;
  for (const Field& field : fields) known += (known.empty() ? "" : ", ") + field.name;
  throw UsageError("there is no field \"" + std::string(name) + "\"; there are " + known);
}

double number_in(const FieldValue& value, bool bar) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* measured = std::get_if<Measured>(&value)) return bar ? measured->error : measured->value;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? 1 : 0;
  return unknown;
}

void add_numbers(std::span<const Field> fields, const void* whole, std::string_view path,
                 std::vector<double>& numbers) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  const std::string_view name = path.substr(0, dot);
  const bool deeper = dot < path.size();
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
    return field.name == name || (!deeper && !field.bar.empty() && field.bar == name);
  });
  if (found == fields.end() || deeper == static_cast<bool>(found->get)) refuse(fields, name);
  if (!deeper) return numbers.push_back(number_in(found->get(whole), found->name != name));
  found->each(whole, [&](const void* part) { add_numbers(found->members, part, path.substr(dot + 1), numbers); });
}

}  // namespace

std::vector<double> numbers_at(std::span<const Field> fields, const void* whole, std::string_view path) {
  std::vector<double> numbers;
  add_numbers(fields, whole, path, numbers);
  return numbers;
}

}  // namespace lober::operations
