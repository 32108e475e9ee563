// A structured NumPy array: numpy.load reads it.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/batch/export/export_formats.hpp"
#include "engine/batch/manifest/swept_options.hpp"

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

// A column of a swept option.
struct SweptField {
  std::string key;
  OptionValue any;    // whose type all values have
  std::size_t width;  // width of the longest value as text
};

std::string type_of(const SweptField& field) {
  if (std::holds_alternative<bool>(field.any)) return "|b1";
  if (std::holds_alternative<std::int64_t>(field.any)) return "<i8";
  return std::holds_alternative<double>(field.any) ? "<f8" : "|S" + std::to_string(field.width);
}

// Null for an option that a group does not have, such as a parameter. Points and lists are written as text.
void put_option(std::string& bytes, const OptionValue* value, const SweptField& field) {
  const bool is_text = std::holds_alternative<std::string>(field.any) || !numbers_of(field.any).empty();
  if (is_text) return put(bytes, value == nullptr ? std::string() : to_string(*value), field.width);
  if (value == nullptr) return put_value(bytes, std::numeric_limits<double>::quiet_NaN());
  if (const auto* flag = std::get_if<bool>(value)) return put_value(bytes, *flag);
  if (const auto* whole = std::get_if<std::int64_t>(value)) return put_value(bytes, *whole);
  put_value(bytes, std::get<double>(*value));
}

std::size_t longest_text(const Plan& plan, const std::string& key) {
  std::size_t width = 1;
  for (const JobGroup& group : plan.groups) {
    const OptionValue* const value = group.options.find(key);
    if (value != nullptr) width = std::max(width, to_string(*value).size());
  }
  return width;
}

}  // namespace

void write_npy_table(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results) {
  // The width of a text column is that of its longest text, so that all rows are looked at twice.
  std::size_t count = 0;
  std::size_t widths[5] = {1, 1, 1, 1, 1};
  const auto texts = [&](const Result& result) {
    const Job& job = plan.jobs[result.job];
    const JobGroup& group = plan.group_of(job);
    return std::array<std::string, 5>{group.name, group.options.to_string(), plan.name(job.first),
                                      plan.name(job.second), result.error};
  };
  results([&](const Result& result) {
    ++count;
    const auto all = texts(result);
    for (std::size_t k = 0; k < all.size(); ++k) widths[k] = std::max(widths[k], all[k].size());
  });
  constexpr const char* names[] = {"group", "options", "first", "second", "message"};
  std::string header = "{'descr': [('job', '<i8'), ('failed', '|b1'), ";
  for (std::size_t k = 0; k < std::size(names); ++k) {
    header += std::string("('") + names[k] + "', '|S" + std::to_string(widths[k]) + "'), ";
  }
  std::vector<SweptField> swept;
  for (const SweptOption& option : swept_options(plan, operation)) {
    swept.push_back({option.key, any_value(option, plan, operation), longest_text(plan, option.key)});
    header += "('" + option.column + "', '" + type_of(swept.back()) + "'), ";
  }
  for (const Column& column : operation.columns) {
    header += "('" + column.name + "', '" + (column.kind == Column::Kind::count ? "<i8" : "<f8") + "'), ";
  }
  header += "], 'fortran_order': False, 'shape': (" + std::to_string(count) + ",), }";
  constexpr std::size_t before = 12;  // magic string, version 2.0, length of the header in four bytes
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x02\x00", 8);
  put_value(bytes, static_cast<std::uint32_t>(header.size()));
  bytes += header;
  results([&](const Result& result) {
    put_value(bytes, static_cast<std::int64_t>(result.job));
    put_value(bytes, result.failed());
    const auto all = texts(result);
    for (std::size_t k = 0; k < all.size(); ++k) put(bytes, all[k], widths[k]);
    const Options& options = plan.group_of(plan.jobs[result.job]).options;
    for (const SweptField& field : swept) put_option(bytes, options.find(field.key), field);
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
