// A structured NumPy array: numpy.load reads it.

#include <bit>
#include <cmath>
#include <limits>

#include "engine/base/npy_table.hpp"
#include "engine/batch/export/table_columns.hpp"

namespace lober::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "the header below says so");

void put(std::string& bytes, const std::string& text, std::size_t width) {
  bytes += text;
  bytes.append(width - text.size(), '\0');
}

template <typename T>
void put_value(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string type_of(const SweptColumn& field) {
  if (std::holds_alternative<bool>(field.any)) return "|b1";
  if (std::holds_alternative<std::int64_t>(field.any)) return "<i8";
  return std::holds_alternative<double>(field.any) ? "<f8" : "|S" + std::to_string(field.width);
}

// Null for an option that a group does not have, such as a parameter. Points and lists are written as text.
void put_option(std::string& bytes, const OptionValue* value, const SweptColumn& field) {
  if (field.is_text()) return put(bytes, value == nullptr ? std::string() : to_string(*value), field.width);
  if (value == nullptr) return put_value(bytes, std::numeric_limits<double>::quiet_NaN());
  if (const auto* flag = std::get_if<bool>(value)) return put_value(bytes, *flag);
  if (const auto* whole = std::get_if<std::int64_t>(value)) return put_value(bytes, *whole);
  put_value(bytes, std::get<double>(*value));
}

}  // namespace

void write_npy_table(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results) {
  const TableColumns columns = table_columns(plan, operation, results);
  std::vector<std::pair<std::string, std::string>> fields{{"job", "<i8"}, {"failed", "|b1"}};
  for (std::size_t k = 0; k < text_columns.size(); ++k) {
    fields.emplace_back(text_columns[k], "|S" + std::to_string(columns.widths[k]));
  }
  for (const SweptColumn& option : columns.swept) fields.emplace_back(option.name, type_of(option));
  for (const Column& column : operation.columns) {
    fields.emplace_back(column.name, column.kind == Column::Kind::count ? "<i8" : "<f8");
  }
  std::string bytes = npy_table_head(fields, columns.rows);
  results([&](const Result& result) {
    put_value(bytes, static_cast<std::int64_t>(result.job));
    put_value(bytes, result.failed());
    const auto all = texts_of(plan, result);
    for (std::size_t k = 0; k < all.size(); ++k) put(bytes, all[k], columns.widths[k]);
    const Options& options = plan.group_of(plan.jobs[result.job]).options;
    for (const SweptColumn& field : columns.swept) put_option(bytes, options.find(field.key), field);
    for (std::size_t k = 0; k < operation.columns.size(); ++k) {
      const double value = result.failed() ? std::numeric_limits<double>::quiet_NaN() : result.values.at(k);
      if (operation.columns[k].kind == Column::Kind::count) {
        put_value(bytes, std::isfinite(value) ? static_cast<std::int64_t>(value) : std::int64_t{-1});
      } else {
        put_value(bytes, value);
      }
    }
    if (bytes.size() < (std::size_t{1} << 20)) return;
    file.write(bytes);
    bytes.clear();
  });
  file.write(bytes);
}

}  // namespace lober::detail
