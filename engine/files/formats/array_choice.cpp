#include "engine/files/formats/array_choice.hpp"

#include <algorithm>
#include <array>

#include "engine/files/column_choice.hpp"
#include "engine/files/text_cells.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

using NamesMatch = bool (*)(std::string_view, std::string_view);
bool same_exactly(std::string_view a, std::string_view b) {
  return a == b;
}

class ArrayChooser {
 public:
  ArrayChooser(const std::vector<ArrayInfo>& arrays, const std::string& path) : arrays_(arrays), path_(path) {}

  [[nodiscard]] ChosenArrays chosen_by(std::string_view choice) const {
    ChosenArrays chosen;
    for (const ChoicePart& part : parts_of_choice(choice)) {
      const std::size_t index = named(part.name);
      if (part.key == "by") {
        chosen.group = index;
      } else if (part.key == "offsets") {
        chosen.offsets = index;
      } else if (part.key == "counts") {
        chosen.counts = index;
      } else {
        chosen.coordinates.push_back(index);
      }
    }
    const int partings =
        int{chosen.group.has_value()} + int{chosen.offsets.has_value()} + int{chosen.counts.has_value()};
    if (chosen.coordinates.empty() || chosen.coordinates.size() > 2 || partings > 1) {
      fail("arrays are chosen by \"X,Y\" or \"XY\", and perhaps by=ID, offsets=O or counts=N, not by " +
           quoted_text(choice));
    }
    return chosen;
  }

  // The choice that is meant where nothing is chosen.
  [[nodiscard]] ChosenArrays evident() const {
    constexpr std::array<std::array<std::string_view, 2>, 3> pairs{
        {{"x", "y"}, {"lon", "lat"}, {"longitude", "latitude"}}};
    if (const auto points = whole("points", same_exactly), offsets = whole("offsets", same_exactly);
        points && offsets) {
      return {{*points}, {}, offsets, {}};
    }
    for (const NamesMatch match : {same_exactly, same_in_any_case}) {
      for (const auto& [first, second] : pairs) {
        const auto x = whole(first, match), y = whole(second, match);
        if (x && y && arrays_[*x].shape == arrays_[*y].shape && arrays_[*x].axes == arrays_[*y].axes) {
          return {{*x, *y}, {}, {}, {}};
        }
      }
    }
    const auto is_evident = [](const ArrayInfo& array) {
      return holds_points(array) && !array.is_link && (!array.is_complex || array.size() > 1);
    };
    if (std::count_if(arrays_.begin(), arrays_.end(), is_evident) == 1) {
      const auto only = std::find_if(arrays_.begin(), arrays_.end(), is_evident);
      return {{static_cast<std::size_t>(only - arrays_.begin())}, {}, {}, {}};
    }
    fail("which arrays are x and y? Name them, " + path_ + ":X,Y, or one of N x 2, " + path_ + ":XY; " + holds());
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw DataError(path_ + ": " + message); }

  [[nodiscard]] std::string list() const {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t k = 0; k < std::min(arrays_.size(), most); ++k)
      text += (k == 0 ? "" : ", ") + described(arrays_[k]);
    return arrays_.size() > most ? text + " and " + std::to_string(arrays_.size() - most) + " more" : text;
  }

  [[nodiscard]] std::string holds() const {
    return arrays_.empty() ? "it holds no arrays of numbers" : "it holds " + list();
  }

  [[nodiscard]] std::optional<std::size_t> whole(std::string_view name, NamesMatch match) const {
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      if (match(arrays_[k].name, name) || match(arrays_[k].name, "/" + std::string(name))) return k;
    }
    return std::nullopt;
  }

  // By its whole name, or by the last part of only one; of links only where nothing else is called so.
  [[nodiscard]] std::optional<std::size_t> found(std::string_view name, NamesMatch match) const {
    if (const std::optional<std::size_t> index = whole(name, match)) return index;
    for (const bool links : {false, true}) {
      std::optional<std::size_t> by_part;
      for (std::size_t k = 0; k < arrays_.size(); ++k) {
        if (arrays_[k].is_link != links || !match(last_part(arrays_[k].name), name)) continue;
        if (by_part) fail("several arrays are called " + quoted_text(name) + "; " + holds());
        by_part = k;
      }
      if (by_part) return by_part;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t named(std::string_view name) const {
    for (const NamesMatch match : {same_exactly, same_in_any_case}) {
      if (const std::optional<std::size_t> index = found(name, match)) return *index;
    }
    fail("has no array of numbers called " + quoted_text(name) + "; " + holds());
  }

  const std::vector<ArrayInfo>& arrays_;
  const std::string& path_;
};

}  // namespace

ChosenArrays choose_arrays(const std::vector<ArrayInfo>& arrays, std::string_view choice, const std::string& path) {
  const ArrayChooser chooser(arrays, path);
  return choice.empty() ? chooser.evident() : chooser.chosen_by(choice);
}

std::string described(const ArrayInfo& array) {
  std::string text = array.name + " (";
  for (const std::size_t& size : array.shape) text += (&size == array.shape.data() ? "" : " x ") + std::to_string(size);
  if (array.shape.empty()) text += "a number";
  if (!array.pieces.empty()) text += " in " + std::to_string(array.pieces.size()) + " pieces";
  return text + (array.is_complex ? ", complex)" : ")");
}

std::string last_part(const std::string& name) {
  return name.substr(name.rfind('/') + 1);
}

bool holds_points(const ArrayInfo& array) {
  if (array.size() == 0) return false;
  return array.is_complex || (array.shape.size() == 2 && (array.shape[0] == 2 || array.shape[1] == 2));
}

bool same_in_any_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace lober::detail
