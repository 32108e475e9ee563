#include "cli/program/option_names.hpp"

#include <array>
#include <utility>

#include "cli/program/table_options.hpp"
#include "engine/base/quantities.hpp"

namespace lober::cli {
namespace {

namespace quantity = detail::quantity;
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> options_of_quantities{{
    {quantity::points, "--max-points"},
    {quantity::seconds, "--budget"},
    {quantity::tolerance, "--tolerance"},
    {quantity::saddle, "--from"},
    {quantity::saddles, "--saddle"},
    {quantity::section, "--section"},
    {quantity::store, "--store"},
    {quantity::search, "lober fixed-points"},
    {quantity::passes, "--passes; -DENS of published forms"},
}};

}  // namespace

std::string with_option_names(std::string_view message) {
  std::string text(message);
  const std::string quoted = "option \"";
  for (std::size_t at = text.find(quoted); at != std::string::npos; at = text.find(quoted, at)) {
    const std::size_t begin = at + quoted.size(), end = text.find('"', begin);
    if (end == std::string::npos) break;
    text.replace(at, end + 1 - at, option_name(text.substr(begin, end - begin)));
  }
  for (const auto& [words, option] : options_of_quantities) {
    const std::size_t at = text.find(words);
    if (at != std::string::npos) text.insert(at + words.size(), " (" + std::string(option) + ")");
  }
  return text;
}

}  // namespace lober::cli
