#include "engine/batch/operations/result_numbers.hpp"

#include <algorithm>
#include <limits>

namespace lober::detail {
using operations::Field;

const Field& ResultNumbers::add(std::string_view path) {
  const std::uint32_t index = size_++;
  std::span<const Field> fields = fields_;
  std::uint32_t outer = 0;
  for (std::string_view rest = path;;) {
    const std::string_view name = rest.substr(0, rest.find('.'));
    const Field& field = operations::field_at(fields, name);
    const bool is_last = name.size() == rest.size();
    if (is_last && field.number) {
      numbers_.push_back({outer, index, &field, field.name != name});
      return field;
    }
    if (is_last || !field.address) {
      paths_.push_back({index, {fields_, path}});
      return paths_.back().path.field();
    }
    outer = object(outer, field);
    fields = field.members;
    rest.remove_prefix(name.size() + 1);
  }
}

std::uint32_t ResultNumbers::object(std::uint32_t outer, const Field& field) {
  const auto known = std::find_if(objects_.begin(), objects_.end(),
                                  [&](const Object& any) { return any.outer == outer && any.field == &field; });
  const auto number = static_cast<std::uint32_t>(known - objects_.begin());
  if (known == objects_.end()) objects_.push_back({outer, &field});
  return number + 1;
}

Buffer<double> ResultNumbers::operator()(const void* whole) const {
  thread_local std::vector<const void*> objects;
  objects.assign(1, whole);
  for (const auto& [outer, field] : objects_) {
    objects.push_back(objects[outer] != nullptr ? field->address(objects[outer]) : nullptr);
  }
  Buffer<double> found(size_, std::numeric_limits<double>::quiet_NaN());
  for (const auto& [object, index, field, bar] : numbers_) {
    if (objects[object] == nullptr) continue;
    const Measured number = field->number(objects[object]);
    found[index] = bar ? number.error : number.value;
  }
  for (const auto& [index, path] : paths_) found[index] = path.first(whole);
  return found;
}

}  // namespace lober::detail
