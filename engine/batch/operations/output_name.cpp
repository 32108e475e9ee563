#include "engine/batch/operations/output_name.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "lober/curve/formats.hpp"

namespace lober::detail {
namespace {

// Name of the curve's file without folders, and its zone.
std::string stem_of(std::string_view curve) {
  std::string stem(curve.substr(curve.rfind('/') + 1));
  std::replace(stem.begin(), stem.end(), '#', '_');
  return stem;
}

// Endings of files that are not curves in NPY, besides those of other formats of curves.
constexpr std::array<std::string_view, 2> further_endings{".svg", ".gz"};

}  // namespace

std::string_view other_ending(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos) return {};
  const std::string_view ending = name.substr(dot);
  const std::optional<Format> format = format_of_name(name);
  const bool is_other =
      format ? *format != Format::npy
             : std::find(further_endings.begin(), further_endings.end(), ending) != further_endings.end();
  return is_other ? ending : std::string_view();
}

std::string output_name(std::string_view pattern, const Options& options, std::string_view first,
                        std::string_view second) {
  bool for_option = false;  // whether the last hole is that of an option, and ends the name
  const auto filling = [&](std::string_view key) -> std::optional<std::string> {
    if (key == "name") return stem_of(first);
    if (key == "second") return stem_of(second);
    for_option = true;
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
    for_option = false;
    auto filled = close == pattern.npos ? std::nullopt : filling(pattern.substr(1, close - 1));
    if (filled) {
      pattern.remove_prefix(close + 1);
      const bool goes_on = !pattern.empty() && pattern.front() != '/';
      if (goes_on && !for_option) filled->resize(filled->size() - other_ending(*filled).size());
      name += *filled;
      for_option = for_option && pattern.empty();
    } else if (!pattern.empty()) {
      name += pattern.front();
      pattern.remove_prefix(1);
      for_option = false;
    }
  }
  return for_option ? name + ".npy" : name;
}

}  // namespace lober::detail
