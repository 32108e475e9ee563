// Results in JSON.
#include <cmath>

#include "engine/base/json_text.hpp"
#include "lober/operations.hpp"

namespace lober::operations {
namespace {

using detail::json_number;
using detail::json_string;

template <typename Each>
std::string array_of(std::size_t size, const Each& each) {
  std::string text = "[";
  for (std::size_t k = 0; k < size; ++k) text += (k == 0 ? "" : ",") + each(k);
  return text + "]";
}

std::string rows_of(const Matrix& matrix, double Measured::*part) {
  return array_of(matrix.rows, [&](std::size_t i) {
    return array_of(matrix.columns,
                    [&](std::size_t j) { return json_number(matrix.entries[i * matrix.columns + j].*part); });
  });
}

bool is_known(const FieldValue& value) {
  if (const auto* point = std::get_if<Point>(&value)) return !std::isnan(point->x);
  const auto* matrix = std::get_if<Matrix>(&value);
  return matrix == nullptr || !std::isnan(matrix->entries.front().value);
}

class Members {
 public:
  explicit Members(bool outermost) : outermost_(outermost) {}

  void add(const Field& field, const void* whole) {
    if (field.kind == FieldKind::object) {
      std::string value = "null";
      field.each(whole, [&](const void* part) { value = braced(field.members, part); });
      add(field.name, value);
    } else if (field.kind == FieldKind::list) {
      std::string elements;
      field.each(whole, [&](const void* part) {
        elements += elements.empty() ? "" : ",";
        if (outermost_) elements += "\n  ";
        elements += braced(field.members, part);
      });
      add(field.name, "[" + elements + (outermost_ && !elements.empty() ? "\n ]" : "]"));
    } else {
      add_value(field, field.get(whole));
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

  static std::string braced(std::span<const Field> fields, const void* whole) {
    Members inner(false);
    for (const Field& field : fields) inner.add(field, whole);
    return "{" + inner.text_ + "}";
  }

 private:
  void add(const std::string& name, const std::string& value) {
    if (!text_.empty()) text_ += outermost_ ? ",\n" : ",";
    text_ += json_string(name) + (outermost_ ? ": " : ":") + value;
  }

  void add_value(const Field& field, const FieldValue& value) {
    if (std::holds_alternative<std::monostate>(value) || (field.null && !is_known(value))) {
      if (field.null || field.kind == FieldKind::text) add(field.name, "null");
    } else if (const auto* number = std::get_if<double>(&value)) {
      add(field.name, json_number(*number));
    } else if (const auto* measured = std::get_if<Measured>(&value)) {
      add(field.name, json_number(measured->value));
      add(field.bar, json_number(measured->error));
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      add(field.name, std::to_string(*integer));
    } else if (const auto* flag = std::get_if<bool>(&value)) {
      add(field.name, *flag ? "true" : "false");
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      add(field.name, json_string(*text));
    } else if (const auto* lines = std::get_if<std::vector<std::string>>(&value)) {
      add(field.name, array_of(lines->size(), [&](std::size_t k) { return json_string((*lines)[k]); }));
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      add(field.name, array_of(numbers->size(), [&](std::size_t k) { return json_number((*numbers)[k]); }));
    } else if (const auto* wholes = std::get_if<std::vector<std::int64_t>>(&value)) {
      add(field.name, array_of(wholes->size(), [&](std::size_t k) { return std::to_string((*wholes)[k]); }));
    } else if (const auto* point = std::get_if<Point>(&value)) {
      add(field.name, "[" + json_number(point->x) + "," + json_number(point->y) + "]");
    } else if (const auto* matrix = std::get_if<Matrix>(&value)) {
      add(field.name, rows_of(*matrix, &Measured::value));
      if (!field.bar.empty()) add(field.bar, rows_of(*matrix, &Measured::error));
    }
  }

  bool outermost_;
  std::string text_;
};

}  // namespace

std::string json_object(std::span<const Field> fields, const void* whole) {
  return Members::braced(fields, whole);
}

std::string json_members(std::span<const Field> fields, const void* whole) {
  Members members(true);
  for (const Field& field : fields) members.add(field, whole);
  return members.text();
}

}  // namespace lober::operations
