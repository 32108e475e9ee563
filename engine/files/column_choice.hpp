// A choice of columns or arrays, as it stands behind "FILE:" and in ReadOptions::columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lober::detail {

/// A part of a choice: a name, or "by=NAME", "offsets=NAME", "counts=NAME".
struct ChoicePart {
  std::string key;   ///< "by", "offsets", "counts", or empty
  std::string name;  ///< without blanks around it and without quotes

  /// "key=name" or the name.
  [[nodiscard]] std::string whole() const { return key.empty() ? name : key + "=" + name; }
};

/// The parts of "x,y,by=id". A name in quotes may have commas: "\"x, m\",\"y, m\"". An empty choice has one empty part.
[[nodiscard]] std::vector<ChoicePart> parts_of_choice(std::string_view choice);

}  // namespace lober::detail
