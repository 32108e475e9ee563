// Lists of words in messages, and the one of a list that was meant: "did you mean overlay?".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace lober::detail {

/// The number of letters that have to be changed, left out, put in or exchanged with their neighbour to make one word
/// of the other (Damerau & Levenshtein, each letter once). O(a b) for words of a and b letters.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word that `word` is most likely a slip of: the one with the fewest edits, of which a word of up to two
/// letters may have none, up to four letters one, up to eleven two, and a longer one three; or else the only one that
/// begins with `word`, from three letters on. Capitals count as small letters, and _ counts as -. The first of several
/// at the same distance; empty if none is near.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> known);

/// "a, b, c".
[[nodiscard]] std::string joined(std::span<const std::string> words);

/// The end of a message about an unknown word: "; did you mean overlay?", or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace lober::detail
