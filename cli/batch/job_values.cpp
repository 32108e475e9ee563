#include "cli/batch/job_values.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/base/nearest_word.hpp"
#include "engine/batch/export/export.hpp"
#include "engine/batch/operations/option_json.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

const std::string option_prefix = "parameters.";

}  // namespace

std::string short_option(const std::string& key) {
  return key.starts_with(option_prefix) ? key.substr(option_prefix.size()) : key;
}

JobValues::JobValues(const std::string& store, const std::string& operation, const lober::Progress& progress) {
  const detail::Store opened = detail::Store::open(store);
  plan_ = detail::plan_of(opened);
  std::vector<std::string> operations;  // that have results
  const detail::Operation* wanted = nullptr;
  std::vector<detail::Result> found;
  detail::for_each_result(
      opened, plan_, {},
      [&](const detail::Result& result) {
        const detail::Operation* const one = plan_.group_of(plan_.jobs[result.job]).operation;
        if (std::find(operations.begin(), operations.end(), one->name) == operations.end()) {
          operations.push_back(one->name);
        }
        if (result.failed() || (!operation.empty() && one->name != operation)) return;
        wanted = one;
        found.push_back(result);
      },
      progress);
  if (operation.empty() && operations.size() > 1) {
    throw UsageError("the store has several operations; choose one by --operation: " + detail::joined(operations));
  }
  if (!operation.empty() && std::find(operations.begin(), operations.end(), operation) == operations.end()) {
    throw UsageError("--operation " + operation + ": the store has no job of it; there are " +
                     detail::joined(operations));
  }
  if (found.empty()) throw DataError(store + ": no job is done yet, so there is nothing to draw");
  if (wanted->spread) {
    const detail::SpreadTable table = detail::spread_table(*wanted, [&](const auto& take) {
      for (const detail::Result& result : found) take(result);
    });
    operation_ = table.operation;
    table.results([&](const detail::Result& result) { jobs_.push_back(result); });
  } else {
    operation_ = *wanted;
    jobs_ = std::move(found);
  }
  find_varied();
  find_results();
}

void JobValues::find_varied() {
  for (const char* const input : {"first", "second"}) {
    const auto curve = [&](std::size_t k) { return input[0] == 'f' ? job(k).first : job(k).second; };
    for (std::size_t k = 1; k < jobs_.size(); ++k) {
      if (curve(k) == curve(0)) continue;
      varied_.emplace_back(input);
      break;
    }
  }
  // Jobs of one group have the same options.
  std::vector<std::size_t> first_jobs;
  std::set<std::uint32_t> groups;
  std::vector<std::string> options;
  std::set<std::string> known;
  for (std::size_t k = 0; k < jobs_.size(); ++k) {
    if (!groups.insert(job(k).group).second) continue;
    first_jobs.push_back(k);
    for (const auto& [key, value] : plan_.group_of(job(k)).options.settings()) {
      if (known.insert(key).second) options.push_back(short_option(key));
    }
  }
  for (const std::string& name : options) {
    const Json first = option(0, name);
    if (std::any_of(first_jobs.begin(), first_jobs.end(), [&](std::size_t k) { return option(k, name) != first; })) {
      varied_.push_back(name);
    }
  }
}

void JobValues::find_results() {
  for (std::size_t column = 0; column < operation_.columns.size(); ++column) {
    const auto is_known = [&](const detail::Result& one) { return std::isfinite(one.values.at(column)); };
    if (std::any_of(jobs_.begin(), jobs_.end(), is_known)) results_.push_back(operation_.columns[column].name);
  }
}

Json JobValues::option(std::size_t k, const std::string& name) const {
  const detail::Options& options = plan_.group_of(job(k)).options;
  const detail::OptionValue* value = options.find(name);
  if (value == nullptr) value = options.find(option_prefix + name);
  return value != nullptr ? detail::json_of<Json>(*value) : Json();
}

Json JobValues::value(std::size_t k, const std::string& name) const {
  if (Json found = option(k, name); !found.is_null()) return found;
  const auto name_of = [&](detail::CurveId curve) {
    return curve == detail::no_curve ? Json() : Json(plan_.name(curve));
  };
  if (name == "first") return name_of(job(k).first);
  if (name == "second") return name_of(job(k).second);
  return result(k, name);
}

Json JobValues::result(std::size_t k, const std::string& name) const {
  const auto& columns = operation_.columns;
  const auto at = std::find_if(columns.begin(), columns.end(), [&](const auto& one) { return one.name == name; });
  if (at == columns.end()) return {};
  const double number = jobs_[k].values.at(static_cast<std::size_t>(at - columns.begin()));
  if (!std::isfinite(number)) return {};
  return at->kind == detail::Column::Kind::count ? Json(static_cast<std::int64_t>(number)) : Json(number);
}

std::span<const double> JobValues::list(std::size_t k, std::string_view name) const {
  const auto at = std::find(operation_.lists.begin(), operation_.lists.end(), name);
  const auto number = static_cast<std::size_t>(at - operation_.lists.begin());
  return number < jobs_[k].lists.size() ? std::span<const double>(jobs_[k].lists[number]) : std::span<const double>();
}

}  // namespace lober::cli
