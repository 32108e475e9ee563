#include "engine/c/options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lober/base/error.hpp"

namespace lober::detail::c {

std::vector<std::pair<std::string, std::string>> words_of(const char* text) {
  std::vector<std::pair<std::string, std::string>> words;
  std::string_view rest = text ? text : "";
  constexpr std::string_view blanks = " \t\n";
  while (true) {
    const std::size_t begin = rest.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return words;
    rest.remove_prefix(begin);
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      throw UsageError("\"" + std::string(word) + "\" is not of the form NAME=VALUE");
    }
    std::string name(word.substr(0, equals));
    if (std::any_of(words.begin(), words.end(), [&](const auto& other) { return other.first == name; })) {
      throw UsageError(name + " is given twice");
    }
    words.emplace_back(std::move(name), word.substr(equals + 1));
  }
}

double number_of(const std::string& name, const std::string& value) {
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size() || std::isnan(number)) {
    throw UsageError(name + " has to be a number, not \"" + value + "\"");
  }
  return number;
}

void Options::refuse(const std::string& name, const std::string& value, const std::string& wanted) {
  throw UsageError(name + " has to be " + wanted + ", not \"" + value + "\"");
}

std::optional<std::string> Options::text(const std::string& name) {
  known_.insert(name);
  const auto found = std::find_if(words_.begin(), words_.end(), [&](const auto& word) { return word.first == name; });
  return found == words_.end() ? std::nullopt : std::optional(found->second);
}

double Options::number(const std::string& name, double otherwise) {
  const std::optional<std::string> given = text(name);
  return given ? number_of(name, *given) : otherwise;
}

std::int64_t Options::integer(const std::string& name, std::int64_t otherwise, std::int64_t least, std::int64_t most) {
  const std::optional<std::string> given = text(name);
  if (!given) return otherwise;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(given->data(), given->data() + given->size(), value);
  if (error != std::errc() || end != given->data() + given->size() || value < least || value > most) {
    refuse(name, *given, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

bool Options::flag(const std::string& name, bool otherwise) {
  const std::optional<std::string> given = text(name);
  if (given && *given != "0" && *given != "1") refuse(name, *given, "0 or 1");
  return given ? *given == "1" : otherwise;
}

void Options::require_all_known() const {
  const auto unknown =
      std::find_if(words_.begin(), words_.end(), [&](const auto& word) { return !known_.contains(word.first); });
  if (unknown == words_.end()) return;
  std::string message = "\"" + unknown->first + "\" is not an option here; there are ";
  for (const std::string& known : known_) message += (known == *known_.begin() ? "" : ", ") + known;
  throw UsageError(message);
}

}  // namespace lober::detail::c
