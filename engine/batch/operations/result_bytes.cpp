// Results as CBOR, their lists as JSON.

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/batch/operations/bytes.hpp"
#include "engine/batch/operations/option_json.hpp"
#include "engine/batch/operations/options.hpp"
#include "engine/batch/operations/result.hpp"

namespace lober::detail {
namespace {

using Json = nlohmann::json;

template <typename T>
Json array_of(const std::vector<T>& values) {
  return Json::binary(bytes_of(values));
}

template <typename T>
std::vector<T> array_from(const Json& from, std::size_t count) {
  std::vector<T> values = values_of<T>(from.get_binary());
  if (values.size() != count) throw DataError("the results are not all of the same number");
  return values;
}

// JSON has no NaN and no infinities.
constexpr const char *infinity = "Infinity", *minus_infinity = "-Infinity";
Json number_json(double value) {
  if (std::isinf(value)) return value > 0 ? infinity : minus_infinity;
  return std::isnan(value) ? Json() : Json(value);
}
double number_from(const Json& value) {
  if (value == infinity) return std::numeric_limits<double>::infinity();
  if (value == minus_infinity) return -std::numeric_limits<double>::infinity();
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<Result> results_of(const Json& from) {
  const Json& errors = from.at("errors");
  std::vector<Result> results(errors.size());
  const auto jobs = array_from<std::uint32_t>(from.at("jobs"), results.size());
  const auto keys = array_from<JobKey>(from.at("keys"), results.size());
  const auto seconds = array_from<double>(from.at("seconds"), results.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    Result& result = results[k];
    result.job = jobs[k];
    result.key = keys[k];
    result.seconds = seconds[k];
    result.error = errors.at(k).get<std::string>();
    result.digests = from.at("digests").at(k).get<std::array<std::string, 2>>();
    result.values = values_of<double>(from.at("values").at(k).get_binary());
    for (const Json& list : from.at("lists").at(k)) result.lists.push_back(values_of<double>(list.get_binary()));
  }
  return results;
}

}  // namespace

std::string encoded(std::span<const Result> results) {
  std::vector<std::uint32_t> jobs;
  std::vector<JobKey> keys;
  std::vector<double> seconds;
  Json made;
  for (const char* const key : {"errors", "digests", "values", "lists"}) made[key] = Json::array();
  for (const Result& result : results) {
    jobs.push_back(result.job);
    keys.push_back(result.key);
    seconds.push_back(result.seconds);
    made["errors"].push_back(result.error);
    made["digests"].push_back(result.digests);
    made["values"].push_back(array_of(result.values));
    Json lists = Json::array();
    for (const std::vector<double>& list : result.lists) lists.push_back(array_of(list));
    made["lists"].push_back(std::move(lists));
  }
  made["jobs"] = array_of(jobs);
  made["keys"] = array_of(keys);
  made["seconds"] = array_of(seconds);
  std::string bytes;
  Json::to_cbor(made, bytes);
  return bytes;
}

std::vector<Result> decoded_results(std::string_view bytes) {
  try {
    return results_of(Json::from_cbor(bytes));
  } catch (const Json::exception& error) {
    throw DataError(std::string("the bytes cannot be read as results: ") + error.what());
  }
}

std::string encoded_lists(std::span<const std::vector<double>> lists, std::span<const std::string> names) {
  if (std::all_of(lists.begin(), lists.end(), [](const auto& list) { return list.empty(); })) return {};
  Json made = Json::object();
  for (std::size_t k = 0; k < lists.size(); ++k) {
    if (lists[k].empty()) continue;
    Json& list = made[names[k]] = Json::array();
    for (const double value : lists[k]) list.push_back(number_json(value));
  }
  return made.dump();
}

std::vector<std::vector<double>> decoded_lists(std::string_view text, std::span<const std::string> names) {
  std::vector<std::vector<double>> lists(names.size());
  if (text.empty()) return lists;
  try {
    const Json from = Json::parse(text);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto list = from.find(names[k]);
      if (list == from.end()) continue;
      for (const Json& value : *list) lists[k].push_back(number_from(value));
    }
  } catch (const Json::exception& error) {
    throw DataError(std::string("the stored text cannot be read as lists: ") + error.what());
  }
  return lists;
}

std::string encoded_settings(const Options& options) {
  Json made = Json::object();
  for (const auto& [key, value] : options.settings()) {
    const std::size_t dot = key.find('.');
    Json& place = dot == std::string::npos ? made[key] : made[key.substr(0, dot)][key.substr(dot + 1)];
    place = json_of<Json>(value);
  }
  return made.dump();
}

}  // namespace lober::detail
