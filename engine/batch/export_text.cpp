// CSV and JSON lines.

#include <cmath>

#include "engine/batch/export_row.hpp"
#include "engine/batch/text.hpp"

namespace lober {
namespace {

constexpr std::size_t enough = std::size_t{1} << 20;  // to be written at once

std::string number(const Column& column, double value) {
  if (column.kind == Column::Kind::count) return std::to_string(static_cast<std::int64_t>(value));
  return format_number(value);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string json_number(const Column& column, double value) {
  return std::isfinite(value) ? number(column, value) : "null";
}

std::string json_option(const OptionValue& value) {
  const auto* const real = std::get_if<double>(&value);
  const bool is_text = std::holds_alternative<std::string>(value) || (real != nullptr && !std::isfinite(*real));
  return is_text ? json_string(to_string(value)) : to_string(value);
}

}  // namespace

void write_csv(OutputFile& file, const Operation& operation, const EachRow& rows) {
  std::string text = "job,group,operation,options,first,second,status,message";
  for (const Column& column : operation.columns) text += "," + column.name;
  for (const std::string& list : operation.lists) text += "," + list;
  text += "\n";
  rows([&](const ExportRow& row) {
    text += std::to_string(row.job);
    for (const std::string& field : {row.group->name, row.group->operation, row.group->to_string(), row.first,
                                     row.second, std::string(row.failed ? "failed" : "done"), row.message}) {
      text += "," + csv_field(field);
    }
    for (std::size_t k = 0; k < operation.columns.size(); ++k) {
      text += ",";
      if (row.failed || std::isnan(row.record.values.at(k))) continue;
      text += number(operation.columns[k], row.record.values[k]);
    }
    for (std::size_t k = 0; k < operation.lists.size(); ++k) {
      text += ",";
      if (row.failed) continue;
      const std::vector<double>& list = row.record.lists.at(k);
      for (std::size_t m = 0; m < list.size(); ++m) text += (m == 0 ? "" : " ") + format_number(list[m]);
    }
    text += "\n";
    if (text.size() < enough) return;
    file.write(text);
    text.clear();
  });
  file.write(text);
}

void write_json_lines(OutputFile& file, const EachRow& rows) {
  std::string text;
  rows([&](const ExportRow& row) {
    text += "{\"job\":" + std::to_string(row.job) + ",\"group\":" + json_string(row.group->name) +
            ",\"operation\":" + json_string(row.group->operation) + ",\"options\":{";
    const char* comma = "";
    for (const auto& [key, value] : row.group->options) {
      text += comma + json_string(key) + ":" + json_option(value);
      comma = ",";
    }
    text += "}";
    if (!row.first.empty()) text += ",\"first\":" + json_string(row.first);
    if (!row.second.empty()) text += ",\"second\":" + json_string(row.second);
    if (row.failed) {
      text += ",\"status\":\"failed\",\"message\":" + json_string(row.message);
    } else {
      const Operation& operation = operation_of(*row.group);
      text += ",\"status\":\"done\"";
      for (std::size_t k = 0; k < operation.columns.size(); ++k) {
        text += "," + json_string(operation.columns[k].name) + ":" +
                json_number(operation.columns[k], row.record.values.at(k));
      }
      for (std::size_t k = 0; k < operation.lists.size(); ++k) {
        text += "," + json_string(operation.lists[k]) + ":[";
        const std::vector<double>& list = row.record.lists.at(k);
        for (std::size_t m = 0; m < list.size(); ++m) text += (m == 0 ? "" : ",") + json_number({}, list[m]);
        text += "]";
      }
    }
    text += "}\n";
    if (text.size() < enough) return;
    file.write(text);
    text.clear();
  });
  file.write(text);
}

}  // namespace lober
