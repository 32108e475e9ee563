// NetCDF in its classic format with 64-bit offsets (CDF-2), which netCDF4, xarray, scipy and MATLAB read: a record for
// each job, so that rows are written as they come. See Unidata's "NetCDF Classic Format Specification".

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/batch/export/table_columns.hpp"
#include "lober/base/version.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of the file are big-endian");

template <typename T>
void put_big_endian(std::string& bytes, T value) {
  const auto all = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(all.rbegin(), all.rend());
}

void put_word(std::string& bytes, std::size_t value) {
  put_big_endian(bytes, static_cast<std::uint32_t>(value));
}

void put_padding(std::string& bytes, std::size_t size) {
  bytes.append((4 - size % 4) % 4, '\0');
}

void put_name(std::string& bytes, std::string_view name) {
  put_word(bytes, name.size());
  bytes += name;
  put_padding(bytes, name.size());
}

constexpr std::size_t dimensions_tag = 10, variables_tag = 11, attributes_tag = 12;
constexpr std::size_t characters = 2, doubles = 6;

using Attributes = std::vector<std::pair<std::string, std::string>>;

void put_attributes(std::string& bytes, const Attributes& attributes) {
  put_word(bytes, attributes.empty() ? 0 : attributes_tag);
  put_word(bytes, attributes.size());
  for (const auto& [name, text] : attributes) {
    put_name(bytes, name);
    put_word(bytes, characters);
    put_name(bytes, text);
  }
}

// A column: numbers where `width` is 0, otherwise texts of that width.
struct Variable {
  std::string name;
  std::size_t width = 0;
  Attributes attributes{};
  [[nodiscard]] std::size_t size() const { return width == 0 ? sizeof(double) : (width + 3) / 4 * 4; }
};

// The head: dimensions `job`, of the records, and one for the width of each text; then the variables.
std::string head_of(std::size_t records, const std::vector<Variable>& variables, const Attributes& about) {
  std::string bytes("CDF\x02", 4);
  put_word(bytes, records);
  std::size_t texts = 0;
  for (const Variable& variable : variables) texts += variable.width > 0 ? 1 : 0;
  put_word(bytes, dimensions_tag);
  put_word(bytes, 1 + texts);
  put_name(bytes, "row");
  put_word(bytes, 0);  // that of the records
  for (const Variable& variable : variables) {
    if (variable.width == 0) continue;
    put_name(bytes, variable.name + "_length");
    put_word(bytes, variable.width);
  }
  put_attributes(bytes, about);
  put_word(bytes, variables_tag);
  put_word(bytes, variables.size());
  // Offsets of all variables follow the head, whose length does not depend on them.
  constexpr std::size_t words_of_number = 4, words_of_text = 5, of_offset = 8;
  std::size_t begin = bytes.size();
  for (const Variable& variable : variables) {
    std::string texts_of_head;
    put_name(texts_of_head, variable.name);
    put_attributes(texts_of_head, variable.attributes);
    begin += texts_of_head.size() + 4 * (variable.width == 0 ? words_of_number : words_of_text) + of_offset;
  }
  std::size_t text = 0;
  for (const Variable& variable : variables) {
    put_name(bytes, variable.name);
    put_word(bytes, variable.width == 0 ? 1 : 2);
    put_word(bytes, 0);
    if (variable.width > 0) put_word(bytes, ++text);
    put_attributes(bytes, variable.attributes);
    put_word(bytes, variable.width == 0 ? doubles : characters);
    put_word(bytes, variable.size());
    put_big_endian(bytes, static_cast<std::uint64_t>(begin));
    begin += variable.size();
  }
  return bytes;
}

void put_text(std::string& bytes, std::string text, std::size_t width) {
  text.resize(width, '\0');
  bytes += text;
  put_padding(bytes, width);
}

void put_swept(std::string& bytes, const OptionValue* value, const SweptColumn& column) {
  if (column.is_text()) return put_text(bytes, value == nullptr ? std::string() : to_string(*value), column.width);
  put_big_endian(bytes, swept_number(value));
}

}  // namespace

void write_netcdf(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results) {
  const TableColumns columns = table_columns(plan, operation, results);
  constexpr std::size_t max_records = 0xFFFFFFFE;
  if (columns.rows > max_records) throw DataError("NetCDF: more rows than its classic format has numbers for");
  std::vector<Variable> variables{{"job"}, {"failed"}};
  for (std::size_t k = 0; k < text_columns.size(); ++k) {
    variables.push_back({std::string(text_columns[k]), columns.widths[k]});
  }
  for (const SweptColumn& option : columns.swept) {
    variables.push_back({option.name, option.is_text() ? option.width : 0});
  }
  for (const Column& column : operation.columns) {
    Variable variable{column.name};
    // The names of CF, which xarray and plotting programs look for.
    if (!column.meaning.empty()) variable.attributes.emplace_back("long_name", column.meaning);
    if (!column.unit.empty()) variable.attributes.emplace_back("units", column.unit);
    variables.push_back(std::move(variable));
  }
  const std::string encoded = plan.encoded();
  std::string bytes = head_of(columns.rows, variables,
                              {{"lober", std::string(version())},
                               {"operation", operation.name},
                               {"plan_sha256", sha256(std::as_bytes(std::span(encoded)))}});
  results([&](const Result& result) {
    put_big_endian(bytes, static_cast<double>(result.job));
    put_big_endian(bytes, result.failed() ? 1.0 : 0.0);
    std::array<std::string, 5> texts = texts_of(plan, result);
    for (std::size_t k = 0; k < texts.size(); ++k) put_text(bytes, std::move(texts[k]), columns.widths[k]);
    const Options& options = plan.group_of(plan.jobs[result.job]).options;
    for (const SweptColumn& column : columns.swept) put_swept(bytes, options.find(column.key), column);
    for (std::size_t k = 0; k < operation.columns.size(); ++k) {
      put_big_endian(bytes, result.failed() ? std::numeric_limits<double>::quiet_NaN() : result.values.at(k));
    }
    if (bytes.size() < (std::size_t{1} << 20)) return;
    file.write(bytes);
    bytes.clear();
  });
  file.write(bytes);
}

}  // namespace lober::detail
