// Results as CBOR, their lists as JSON.

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_map>

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
std::vector<T> array_from(const Json& from) {
  return values_of<T>(from.get_binary());
}
template <typename T>
std::vector<T> array_from(const Json& from, std::size_t count) {
  std::vector<T> values = array_from<T>(from);
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

// Lists of numbers, one after the other.
struct Numbers {
  std::vector<std::uint32_t> counts;
  std::vector<double> numbers;

  void add(std::span<const double> list) {
    counts.push_back(static_cast<std::uint32_t>(list.size()));
    numbers.insert(numbers.end(), list.begin(), list.end());
  }
  [[nodiscard]] Json json() const { return {{"counts", array_of(counts)}, {"numbers", array_of(numbers)}}; }
};

class NumbersReader {
 public:
  explicit NumbersReader(const Json& from)
      : lists_{array_from<std::uint32_t>(from.at("counts")), array_from<double>(from.at("numbers"))} {}

  [[nodiscard]] std::span<const double> next() {
    if (list_ == lists_.counts.size() || lists_.counts[list_] > lists_.numbers.size() - number_) {
      throw DataError("the results end too early");
    }
    const auto begin = lists_.numbers.begin() + static_cast<std::ptrdiff_t>(number_);
    const std::uint32_t count = lists_.counts[list_++];
    number_ += count;
    return {begin, begin + count};
  }

 private:
  Numbers lists_;
  std::size_t list_ = 0, number_ = 0;
};

// Results share their digests and have no error as a rule: each text is sent once.
class Texts {
 public:
  [[nodiscard]] std::uint32_t number_of(std::string_view text) {
    const auto [at, is_new] = numbers_.try_emplace(text, static_cast<std::uint32_t>(texts_.size()));
    if (is_new) texts_.emplace_back(text);
    return at->second;
  }
  [[nodiscard]] const std::vector<std::string>& all() const { return texts_; }

 private:
  std::unordered_map<std::string_view, std::uint32_t> numbers_;  // views of the results
  std::vector<std::string> texts_;
};

constexpr std::size_t texts_of_a_result = 3;  // its digests and its error

DecodedResults results_of(const Json& from) {
  const auto jobs = array_from<std::uint32_t>(from.at("jobs"));
  const auto keys = array_from<JobKey>(from.at("keys"), jobs.size());
  const auto seconds = array_from<double>(from.at("seconds"), jobs.size());
  const auto list_counts = array_from<std::uint32_t>(from.at("list_counts"), jobs.size());
  const auto texts = array_from<std::uint32_t>(from.at("texts"), texts_of_a_result * jobs.size());
  DecodedResults decoded{std::vector<Result>(jobs.size()), from.at("all_texts").get<std::vector<std::string>>()};
  NumbersReader values(from.at("values")), lists(from.at("lists"));
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    Result& result = decoded.results[k];
    result.job = jobs[k];
    result.key = keys[k];
    result.seconds = seconds[k];
    const std::span<const double> own = values.next();
    result.values.assign(own.begin(), own.end());
    for (std::uint32_t list = 0; list < list_counts[k]; ++list) {
      const std::span<const double> numbers = lists.next();
      result.lists.emplace_back(numbers.begin(), numbers.end());
    }
    const auto text = [&](std::size_t number) -> const std::string& {
      const std::uint32_t at = texts[texts_of_a_result * k + number];
      if (at >= decoded.texts.size()) throw DataError("a result has a text that is not there");
      return decoded.texts[at];
    };
    result.digests = {text(0), text(1)};
    result.error = text(2);
  }
  return decoded;
}

}  // namespace

std::string encoded(std::span<const Result> results) {
  std::vector<std::uint32_t> jobs, list_counts, texts;
  std::vector<JobKey> keys;
  std::vector<double> seconds;
  Numbers values, lists;
  Texts all_texts;
  for (const Result& result : results) {
    jobs.push_back(result.job);
    keys.push_back(result.key);
    seconds.push_back(result.seconds);
    values.add(result.values);
    list_counts.push_back(static_cast<std::uint32_t>(result.lists.size()));
    for (const std::vector<double>& list : result.lists) lists.add(list);
    for (const std::string_view text : {result.digests[0], result.digests[1], std::string_view(result.error)}) {
      texts.push_back(all_texts.number_of(text));
    }
  }
  const Json made = {{"jobs", array_of(jobs)},
                     {"keys", array_of(keys)},
                     {"seconds", array_of(seconds)},
                     {"values", values.json()},
                     {"list_counts", array_of(list_counts)},
                     {"lists", lists.json()},
                     {"texts", array_of(texts)},
                     {"all_texts", all_texts.all()}};
  std::string bytes;
  Json::to_cbor(made, bytes);
  return bytes;
}

DecodedResults decoded_results(std::string_view bytes) {
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
