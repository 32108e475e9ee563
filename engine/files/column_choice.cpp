#include "engine/files/column_choice.hpp"

#include <algorithm>

#include "engine/files/text_cells.hpp"

namespace lober::detail {

std::vector<ChoicePart> parts_of_choice(std::string_view choice) {
  std::vector<ChoicePart> parts;
  for (bool more = true; more;) {
    std::size_t end = 0;
    for (bool quoted = false; end < choice.size() && (quoted || choice[end] != ','); ++end) {
      if (choice[end] == '"') quoted = !quoted;
    }
    std::string_view one = without_blanks(choice.substr(0, end));
    more = end < choice.size();
    choice.remove_prefix(std::min(end + 1, choice.size()));
    ChoicePart part;
    for (const std::string_view key : {"by", "offsets", "counts"}) {
      const std::string_view behind = one.starts_with(key) ? without_blanks(one.substr(key.size())) : "";
      if (!behind.starts_with('=')) continue;
      part.key = key;
      one = without_blanks(behind.substr(1));
      break;
    }
    part.name = text_of_cell(one);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace lober::detail
