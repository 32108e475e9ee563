// The names of the curves of a file, as they are written behind '#'.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

#include "lober/base/export.hpp"
#include "lober/curve/files.hpp"

namespace lober {

/// Names and zones of a file, both ways: find(name(k)) == k for every k. A zone that a group or a row gave goes by its
/// title where the title is its alone, every other one by its position, counted from 0. The file outlives this.
class ZoneNames {
 public:
  /// O(number of zones).
  LOBER_API explicit ZoneNames(const CurveFile& file);
  /// The name of zone `k`: its title, or its position.
  [[nodiscard]] LOBER_API std::string name(std::size_t k) const;
  /// Whether the name of zone `k` is its title.
  [[nodiscard]] LOBER_API bool named_by_title(std::size_t k) const;
  /// The zone that `choice` names; a title is found too where zones go by their positions. Throws DataError when there
  /// is none, or more than one.
  [[nodiscard]] LOBER_API std::size_t find(const std::string& choice) const;
  /// "FILE#0 to FILE#5", for messages: ids where they are numbers, else positions; `path` may have columns behind the
  /// file.
  [[nodiscard]] LOBER_API std::string range(const std::string& path) const;
  /// The titles of zones, each once, for messages: "\"a\", \"b\" and 3 more", where eight are named at most. Empty
  /// where zones have no titles but their positions.
  [[nodiscard]] LOBER_API std::string titles() const;

 private:
  struct Titled {
    std::size_t first = 0, count = 0;
  };
  [[nodiscard]] bool is_unique(const std::string& title) const;

  const CurveFile& file_;
  std::unordered_map<std::string_view, Titled> titled_;
  bool numbers_ = false;  ///< titles are numbers, each once: a number behind '#' is one of them
};

}  // namespace lober
