#include "engine/batch/operations/output_name.hpp"

#include <algorithm>
#include <optional>

namespace lober::detail {
namespace {

// Name of the curve's file without folders, and its zone.
std::string stem_of(std::string_view curve) {
  std::string stem(curve.substr(curve.rfind('/') + 1));
  std::replace(stem.begin(), stem.end(), '#', '_');
  return stem;
}

}  // namespace

std::string output_name(std::string_view pattern, const Options& options, std::string_view first,
                        std::string_view second) {
  const auto filling = [&](std::string_view key) -> std::optional<std::string> {
    if (key == "name") return stem_of(first);
    if (key == "second") return stem_of(second);
    for (const OptionSetting& setting : options.settings()) {
      // A pattern within itself would have no end.
      if (setting.key == key && key != "output") return to_string(setting.value);
    }
    return std::nullopt;
  };
  std::string name;
  while (!pattern.empty()) {
    const std::size_t open = std::min(pattern.find('{'), pattern.size());
    name += pattern.substr(0, open);
    pattern.remove_prefix(open);
    const std::size_t close = pattern.find('}');
    const auto filled = close == pattern.npos ? std::nullopt : filling(pattern.substr(1, close - 1));
    if (filled) {
      name += *filled;
      pattern.remove_prefix(close + 1);
    } else if (!pattern.empty()) {
      name += pattern.front();
      pattern.remove_prefix(1);
    }
  }
  return name;
}

}  // namespace lober::detail
