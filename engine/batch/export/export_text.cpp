// CSV and JSON lines.

#include <cmath>

#include "engine/base/json_text.hpp"
#include "engine/batch/export/export_formats.hpp"
#include "engine/batch/manifest/swept_options.hpp"

namespace lober::detail {
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
  if (!numbers_of(value).empty()) return "[" + to_string(value) + "]";
  const auto* const real = std::get_if<double>(&value);
  const bool is_text = std::holds_alternative<std::string>(value) || (real != nullptr && !std::isfinite(*real));
  return is_text ? json_string(to_string(value)) : to_string(value);
}

}  // namespace

void write_csv(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results) {
  const std::vector<SweptOption> swept = swept_options(plan, operation);
  std::string text = "job,group,operation,options,first,second,status,message";
  for (const SweptOption& option : swept) text += "," + csv_field(option.column);
  for (const Column& column : operation.columns) text += "," + column.name;
  for (const std::string& list : operation.lists) text += "," + list;
  text += "\n";
  results([&](const Result& result) {
    const Job& job = plan.jobs[result.job];
    const JobGroup& group = plan.group_of(job);
    text += std::to_string(result.job);
    for (const std::string& field :
         {group.name, group.operation->name, group.options.to_string(), plan.name(job.first), plan.name(job.second),
          std::string(result.failed() ? "failed" : "done"), result.error}) {
      text += "," + csv_field(field);
    }
    for (const SweptOption& option : swept) {
      const OptionValue* const value = group.options.find(option.key);
      text += "," + (value != nullptr ? csv_field(to_string(*value)) : "");
    }
    for (std::size_t k = 0; k < operation.columns.size(); ++k) {
      text += ",";
      if (result.failed() || std::isnan(result.values.at(k))) continue;
      text += number(operation.columns[k], result.values[k]);
    }
    for (std::size_t k = 0; k < operation.lists.size(); ++k) {
      text += ",";
      if (result.failed()) continue;
      const std::vector<double>& list = result.lists.at(k);
      for (std::size_t m = 0; m < list.size(); ++m) text += (m == 0 ? "" : " ") + format_number(list[m]);
    }
    text += "\n";
    if (text.size() < enough) return;
    file.write(text);
    text.clear();
  });
  file.write(text);
}

void write_json_lines(OutputFile& file, const Plan& plan, const EachResult& results) {
  std::string text;
  results([&](const Result& result) {
    const Job& job = plan.jobs[result.job];
    const JobGroup& group = plan.group_of(job);
    text += "{\"job\":" + std::to_string(result.job) + ",\"group\":" + json_string(group.name) +
            ",\"operation\":" + json_string(group.operation->name) + ",\"options\":{";
    const char* comma = "";
    for (const auto& [key, value] : group.options.settings()) {
      text += comma + json_string(key) + ":" + json_option(value);
      comma = ",";
    }
    text += "}";
    if (job.first != no_curve) text += ",\"first\":" + json_string(plan.name(job.first));
    if (job.second != no_curve) text += ",\"second\":" + json_string(plan.name(job.second));
    if (result.failed()) {
      text += ",\"status\":\"failed\",\"message\":" + json_string(result.error);
    } else {
      const Operation& operation = *group.operation;
      text += ",\"status\":\"done\"";
      for (std::size_t k = 0; k < operation.columns.size(); ++k) {
        text +=
            "," + json_string(operation.columns[k].name) + ":" + json_number(operation.columns[k], result.values.at(k));
      }
      if (operation.spread) {
        for (const auto& [column, value] : operation.spread(result)) {
          text += "," + json_string(column.name) + ":" + json_number(column, value);
        }
      }
      for (std::size_t k = 0; k < operation.lists.size(); ++k) {
        text += "," + json_string(operation.lists[k]) + ":[";
        const std::vector<double>& list = result.lists.at(k);
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

}  // namespace lober::detail
