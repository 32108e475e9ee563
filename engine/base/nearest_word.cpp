#include "engine/base/nearest_word.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace lober::detail {
namespace {

std::size_t max_edits(std::size_t letters) {
  return letters <= 2 ? 0 : letters <= 4 ? 1 : letters <= 11 ? 2 : 3;
}

std::string folded(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '_') c = '-';
  }
  return text;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); ++k) last[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1]) row[k] = std::min(row[k], before[k - 2] + 1);
    }
    before = std::exchange(last, row);
  }
  return last.back();
}

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t longest = 64;  // a longer word is not a slip, and would take long to compare
  if (word.size() > longest) return {};
  const std::string wanted = folded(word);
  const std::string *nearest = nullptr, *begun = nullptr;
  std::size_t fewest = max_edits(word.size()) + 1, beginnings = 0;
  for (const std::string& one : known) {
    const std::string candidate = folded(one);
    if (candidate.starts_with(wanted)) {
      begun = &one;
      ++beginnings;
    }
    const std::size_t edits = edit_distance(wanted, candidate);
    if (edits >= fewest) continue;
    fewest = edits;
    nearest = &one;
  }
  if (nearest != nullptr) return *nearest;
  return word.size() >= 3 && beginnings == 1 ? *begun : std::string();
}

std::string joined(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::string meant = nearest_word(word, known);
  return meant.empty() ? std::string() : "; did you mean " + meant + "?";
}

}  // namespace lober::detail
