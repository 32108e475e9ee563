#include "lober/curve/zone_names.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "engine/base/nearest_word.hpp"
#include "engine/files/number.hpp"
#include "engine/files/text_cells.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

/// The value of digits and nothing else, also where it is too large for a position.
struct Digits {
  std::size_t value = 0;
  bool fits = true;
};
std::optional<Digits> digits_of(std::string_view text) {
  Digits digits;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), digits.value);
  if (stop != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  digits.fits = error == std::errc{};
  return digits;
}

}  // namespace

ZoneNames::ZoneNames(const CurveFile& file) : file_(file) {
  numbers_ = file.titled_by_group;
  for (std::size_t k = 0; k < file.zones.size(); ++k) {
    const std::string& title = file.zones[k].title;
    Titled& titled = titled_.try_emplace(title, Titled{k}).first->second;
    titled.count += 1;
    double ignored = 0;
    numbers_ = numbers_ && titled.count == 1 && parse_number(title, ignored) == NumberKind::finite;
  }
}

bool ZoneNames::is_unique(const std::string& title) const {
  const auto found = titled_.find(title);
  return found != titled_.end() && found->second.count == 1;
}

bool ZoneNames::named_by_title(std::size_t k) const {
  const std::string& title = file_.zones[k].title;
  return numbers_ || (file_.titled_by_group && !title.empty() && is_unique(title) && !digits_of(title));
}

std::string ZoneNames::name(std::size_t k) const {
  return named_by_title(k) ? file_.zones[k].title : std::to_string(k);
}

std::string ZoneNames::range(const std::string& path) const {
  const auto one = [&](std::size_t k) { return path + "#" + (numbers_ ? name(k) : std::to_string(k)); };
  return one(0) + " to " + one(file_.zones.size() - 1);
}

std::string ZoneNames::titles() const {
  constexpr std::size_t max_named = 8;
  std::string text;
  std::size_t count = 0;
  bool are_positions = true;
  for (std::size_t k = 0; k < file_.zones.size(); ++k) {
    const std::string& title = file_.zones[k].title;
    are_positions = are_positions && title == std::to_string(k);
    if (title.empty() || titled_.at(title).first != k) continue;
    if (++count <= max_named) text += (count == 1 ? "" : ", ") + quoted_text(title);
  }
  if (are_positions) return {};
  return count > max_named ? text + " and " + std::to_string(count - max_named) + " more" : text;
}

std::size_t ZoneNames::find(const std::string& choice) const {
  const std::size_t zones = file_.zones.size();
  const auto fail = [&](const std::string& message) { throw DataError(file_.path + ": " + message); };
  if (const std::optional<Digits> position = digits_of(choice); position && !numbers_) {
    if (position->fits && position->value < zones) return position->value;
    fail("has no zone " + choice + (zones == 1 ? ", only " + file_.path + "#0" : ", only " + range(file_.path)));
  }
  const auto found = titled_.find(choice);
  if (found == titled_.end()) {
    std::vector<std::string> known;
    for (const Zone& zone : file_.zones) known.push_back(zone.title);
    std::string remedy = did_you_mean(choice, known);
    if (remedy.empty()) remedy = titles().empty() ? ", only " + range(file_.path) : "; there are " + titles();
    fail("has no zone titled \"" + choice + "\"" + remedy);
  }
  if (found->second.count > 1) {
    fail("has several zones titled \"" + choice + "\"; choose one of " + range(file_.path));
  }
  return found->second.first;
}

}  // namespace lober
