// HDF5: a dataset of one axis for each column.
#include <cmath>
#include <limits>

#include "engine/base/machine_memory.hpp"
#include "engine/batch/export/table_columns.hpp"
#include "lober/base/version.hpp"
#include "lober/curve/files.hpp"
#include "lober/curve/table_file.hpp"

namespace lober::detail {

void write_hdf5(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results) {
  const TableColumns columns = table_columns(plan, operation, results);
  std::vector<TableColumn> table{{"job"}, {"failed"}};
  for (std::size_t k = 0; k < text_columns.size(); ++k) {
    table.push_back({std::string(text_columns[k]), columns.widths[k]});
  }
  for (const SweptColumn& option : columns.swept) table.push_back({option.name, option.is_text() ? option.width : 0});
  for (const Column& column : operation.columns) table.push_back({column.name});
  std::size_t width = 0;
  for (const TableColumn& column : table) width += column.width == 0 ? sizeof(double) : column.width;
  if (columns.rows > memory_for_unknown_content() / (3 * width)) {  // the columns, the file, and its bytes
    throw DataError("HDF5: the table of " + std::to_string(columns.rows) +
                    " rows needs too much memory; NetCDF (.nc) is written row by row");
  }
  results([&](const Result& result) {
    auto column = table.begin();
    (column++)->add(static_cast<double>(result.job));
    (column++)->add(result.failed() ? 1.0 : 0.0);
    for (std::string& text : texts_of(plan, result)) (column++)->add(std::move(text));
    const Options& options = plan.group_of(plan.jobs[result.job]).options;
    for (const SweptColumn& option : columns.swept) {
      const OptionValue* const value = options.find(option.key);
      if (option.is_text()) {
        (column++)->add(value == nullptr ? std::string() : to_string(*value));
      } else {
        (column++)->add(swept_number(value));
      }
    }
    for (std::size_t k = 0; k < operation.columns.size(); ++k) {
      (column++)->add(result.failed() ? std::numeric_limits<double>::quiet_NaN() : result.values.at(k));
    }
  });
  const std::string encoded = plan.encoded();
  const std::array<std::pair<std::string, std::string>, 3> about{
      {{"lober", std::string(version())},
       {"operation", operation.name},
       {"plan_sha256", sha256(std::as_bytes(std::span(encoded)))}}};
  file.write(hdf5_table(table, about));
}

}  // namespace lober::detail
