#include "engine/files/formats/provenance.hpp"

#include <algorithm>
#include <limits>

namespace lober::detail {

std::string provenance_text(const WriteOptions& options) {
  std::string text;
  for (const auto& [key, value] : options.provenance) {
    if (!text.empty()) text += '\n';
    text.append(key).append(": ").append(value);
  }
  return text;
}

std::string comment_lines(const WriteOptions& options) {
  std::string text;
  for (const auto& [key, value] : options.provenance) {
    const std::size_t begin = text.size();
    text.append("# ").append(key).append(": ").append(value);
    std::replace(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), '\n', ' ');
    text += '\n';
  }
  return text;
}

std::vector<std::string> names_of_numbers(std::span<const Zone> zones) {
  std::vector<std::string> names;
  for (const Zone& zone : zones) {
    for (const auto& [name, number] : zone.numbers) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

std::vector<double> numbers_called(std::string_view name, std::span<const Zone> zones) {
  std::vector<double> numbers;
  for (const Zone& zone : zones) {
    const auto found =
        std::find_if(zone.numbers.begin(), zone.numbers.end(), [&](const auto& one) { return one.first == name; });
    numbers.push_back(found == zone.numbers.end() ? std::numeric_limits<double>::quiet_NaN() : found->second);
  }
  return numbers;
}

}  // namespace lober::detail
