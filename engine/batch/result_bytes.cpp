// Results as CBOR.

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "engine/batch/bytes.hpp"
#include "engine/batch/result.hpp"

namespace lober::detail {
namespace {

using Json = nlohmann::json;
static_assert(std::endian::native == std::endian::little, "the tag of the lists says so");
constexpr std::uint64_t doubles = 86;  // RFC 8746: float64, little endian

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
    throw DataError(std::string("the bytes are no results: ") + error.what());
  }
}

std::string encoded_lists(std::span<const std::vector<double>> lists, std::span<const std::string> names) {
  if (std::all_of(lists.begin(), lists.end(), [](const auto& list) { return list.empty(); })) return {};
  Json made;
  for (std::size_t k = 0; k < lists.size(); ++k) {
    if (!lists[k].empty()) made[names[k]] = Json::binary(bytes_of(lists[k]), doubles);
  }
  std::string bytes;
  Json::to_cbor(made, bytes);
  return bytes;
}

std::vector<std::vector<double>> decoded_lists(std::string_view bytes, std::span<const std::string> names) {
  std::vector<std::vector<double>> lists(names.size());
  if (bytes.empty()) return lists;
  try {
    const Json from = Json::from_cbor(bytes, true, true, Json::cbor_tag_handler_t::store);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (const auto list = from.find(names[k]); list != from.end()) lists[k] = values_of<double>(list->get_binary());
    }
  } catch (const Json::exception& error) {
    throw DataError(std::string("the stored bytes are no lists: ") + error.what());
  }
  return lists;
}

}  // namespace lober::detail
