#include "cli/batch/page_columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cli/batch/job_values.hpp"
#include "engine/base/append_text.hpp"
#include "engine/base/json_text.hpp"
#include "engine/base/utf8.hpp"
#include "engine/batch/export/export.hpp"

namespace lober::cli {
namespace {

using detail::append;
using detail::append_all;
using detail::json_string;

class Columns {
 public:
  Columns(const detail::Store& store, const detail::Plan& plan, ExportCounts& counts) : plan_(plan) {
    counts = detail::for_each_result(store, plan, {}, [&](const detail::Result& one) { jobs_.push_back(one); });
    for (const detail::JobGroup& one : plan.groups) {
      if (!columns_.contains(one.operation)) columns_.emplace(one.operation, spread(*one.operation));
    }
  }

  std::string json() {
    add_numbers("job", "about", [&](std::size_t k) { return static_cast<double>(jobs_[k].job); });
    add_texts("status", "about", [&](std::size_t k) { return jobs_[k].failed() ? "failed" : "done"; });
    add_texts(
        "operation", "about", [&](std::size_t k) { return operation(k).name; }, 2);
    add_texts("first", "given", [&](std::size_t k) { return plan_.name(job(k).first); });
    add_texts("second", "given", [&](std::size_t k) { return plan_.name(job(k).second); });
    add_options();
    add_texts("message", "about", [&](std::size_t k) { return jobs_[k].error; });
    add_results();
    return "[" + json_ + "]";
  }

  // null, or the numbers i and j of lobes and the areas that they have in common; empty where no job has any.
  [[nodiscard]] std::string overlaps() const {
    std::string text;
    bool has_any = false;
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      text += k > 0 ? "," : "";
      const std::vector<std::string>& lists = operation(k).lists;
      const auto at = static_cast<std::size_t>(std::find(lists.begin(), lists.end(), "overlap_i") - lists.begin());
      if (at + 2 >= jobs_[k].lists.size() || jobs_[k].lists[at].empty()) {
        text += "null";
        continue;
      }
      has_any = true;
      text += "{";
      for (std::size_t part = 0; part < 3; ++part) {
        append_all(text, part > 0 ? "," : "", json_string(lists[at + part]), ":[");
        for (const double value : jobs_[k].lists[at + part]) append_number(text, value), text += ",";
        text.back() = ']';
      }
      text += "}";
    }
    return has_any ? "[" + text + "]" : "";
  }

 private:
  [[nodiscard]] const detail::Job& job(std::size_t k) const { return plan_.jobs[jobs_[k].job]; }
  [[nodiscard]] const detail::JobGroup& group(std::size_t k) const { return plan_.group_of(job(k)); }
  [[nodiscard]] const detail::Operation& operation(std::size_t k) const { return *group(k).operation; }

  // Gives the results of an operation the values of the columns into which it spreads lists, and returns all columns.
  std::vector<detail::Column> spread(const detail::Operation& own) {
    if (!own.spread) return own.columns;
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      if (&operation(k) == &own) numbers.push_back(k);
    }
    const detail::SpreadTable table = detail::spread_table(own, [&](const auto& take) {
      for (const std::size_t k : numbers) take(jobs_[k]);
    });
    std::vector<detail::Result> results;
    table.results([&](const detail::Result& one) { results.push_back(one); });
    for (std::size_t k = 0; k < numbers.size(); ++k) jobs_[numbers[k]] = std::move(results[k]);
    return table.operation.columns;
  }

  static void append_number(std::string& text, double value) {
    std::isfinite(value) ? append(text, value) : append(text, "null");
  }
  void begin(const std::string& name, const char* role) {
    append_all(json_, json_.empty() ? "" : ",\n", "{\"name\":", json_string(name), ",\"role\":\"", role, "\",");
  }

  void add_numbers(const std::string& name, const char* role, const std::function<double(std::size_t)>& value) {
    begin(name, role);
    json_ += "\"values\":[";
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      json_ += k > 0 ? "," : "";
      append_number(json_, value(k));
    }
    json_ += "]}";
  }

  // Left out where there are fewer than `min_texts` different ones that are not empty.
  void add_texts(const std::string& name, const char* role, const std::function<std::string(std::size_t)>& text,
                 std::size_t min_texts = 1) {
    std::map<std::string, std::size_t> numbers;
    std::string texts, at;
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      at += k > 0 ? "," : "";
      const std::string one = text(k);
      if (one.empty()) {
        at += "null";
        continue;
      }
      const auto [found, is_new] = numbers.try_emplace(one, numbers.size());
      if (is_new) append_all(texts, texts.empty() ? "" : ",", json_string(detail::as_utf8(one)));
      append(at, found->second);
    }
    if (numbers.size() < min_texts) return;
    begin(name, role);
    append_all(json_, "\"texts\":[", texts, "],\"at\":[", at, "]}");
  }

  void add_options() {
    std::vector<std::string> keys;
    std::map<std::string, std::set<std::string>> values;
    for (const detail::JobGroup& one : plan_.groups) {
      for (const auto& [key, value] : one.options.settings()) {
        std::set<std::string>& all = values[key];
        if (all.empty()) keys.push_back(key);
        all.insert(operations::to_string(value));
      }
    }
    for (const std::string& key : keys) {
      if (values[key].size() < 2) continue;
      const auto value = [&](std::size_t k) { return group(k).options.find(key); };
      const auto number = [&](std::size_t k) {
        const operations::OptionValue* const one = value(k);
        if (one == nullptr) return std::nan("");
        const auto* const whole = std::get_if<std::int64_t>(one);
        const auto* const real = std::get_if<double>(one);
        return whole != nullptr ? static_cast<double>(*whole) : real != nullptr ? *real : HUGE_VAL;
      };
      bool are_numbers = true;
      for (std::size_t k = 0; k < jobs_.size() && are_numbers; ++k) are_numbers = !std::isinf(number(k));
      const std::string name = short_option(key);
      if (are_numbers) {
        add_numbers(name, "given", number);
      } else {
        add_texts(name, "given", [&](std::size_t k) { return value(k) ? operations::to_string(*value(k)) : ""; });
      }
    }
  }

  void add_results() {
    std::vector<std::string> names;
    std::map<std::string, std::map<const detail::Operation*, std::size_t>> positions;  // by name, for each operation
    for (const detail::JobGroup& one : plan_.groups) {
      const std::vector<detail::Column>& columns = columns_.at(one.operation);
      for (std::size_t column = 0; column < columns.size(); ++column) {
        const std::string& name = columns[column].name;
        if (!positions.contains(name)) names.push_back(name);
        positions[name][one.operation] = column;
      }
    }
    for (const std::string& name : names) {
      const auto& by_operation = positions[name];
      const auto value = [&](std::size_t k) {
        const auto at = by_operation.find(&operation(k));
        return jobs_[k].failed() || at == by_operation.end() ? std::nan("") : jobs_[k].values.at(at->second);
      };
      bool is_known = false;
      for (std::size_t k = 0; k < jobs_.size() && !is_known; ++k) is_known = std::isfinite(value(k));
      if (is_known) add_numbers(name, "result", value);
    }
  }

  const detail::Plan& plan_;
  std::vector<detail::Result> jobs_;                                         // with the values of all columns
  std::map<const detail::Operation*, std::vector<detail::Column>> columns_;  // with those of spread lists
  std::string json_;
};

}  // namespace

std::string jobs_json(const std::string& path, ExportCounts& counts) {
  const detail::Store store = detail::Store::open(path);
  const detail::Plan plan = detail::plan_of(store);
  Columns columns(store, plan, counts);
  std::string json;
  append_all(json, "{\"done\":", counts.done, ",\"failed\":", counts.failed, ",\"missing\":", counts.missing,
             ",\"columns\":", columns.json());
  if (const std::string overlaps = columns.overlaps(); !overlaps.empty()) append_all(json, ",\"overlaps\":", overlaps);
  return json + "}";
}

}  // namespace lober::cli
