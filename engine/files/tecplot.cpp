#include "engine/files/tecplot.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

// Independent of the locale, which <cctype> is not.
constexpr char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr bool is_key(char c) {
  return (upper(c) >= 'A' && upper(c) <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper(c);
  return result;
}

/// A header line that is eaten from the left.
class Scanner {
 public:
  Scanner(std::string_view line, const SourceLocation& location) : rest_(line), location_(location) {}

  /// Skips blanks and, on request, commas. False at the end of the line or at a comment.
  bool more(bool commas = false) {
    while (!rest_.empty() && (is_blank(rest_.front()) || (commas && rest_.front() == ','))) rest_.remove_prefix(1);
    return !rest_.empty() && rest_.front() != '#';
  }

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  /// A run of letters, digits and underscores, in upper case.
  std::string key() {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_key);
    return upper(take(static_cast<std::size_t>(end - rest_.begin())));
  }

  /// A quoted string, a group in brackets, or a word that ends at a blank or a comma.
  std::string value() {
    if (rest_.empty()) return {};
    switch (rest_.front()) {
      case '"':
        return escaped_string();
      case '\'':
        return single_quoted();
      case '(':
        return group(')');
      case '[':
        return group(']');
      default:
        return std::string(take(std::min(rest_.find_first_of(" \t\r\f\v,\"'"), rest_.size())));
    }
  }

  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view take(std::size_t count) {
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  [[noreturn]] void unterminated() const { location_.fail("unterminated string: " + quoted_text(rest_)); }

  /// "..." in which \" and \\ stand for " and \ .
  std::string escaped_string() {
    std::string text;
    for (std::size_t i = 1; i < rest_.size(); ++i) {
      if (rest_[i] == '"') {
        take(i + 1);
        return text;
      }
      if (rest_[i] == '\\' && i + 1 < rest_.size() && (rest_[i + 1] == '"' || rest_[i + 1] == '\\')) ++i;
      text += rest_[i];
    }
    unterminated();
  }

  /// '...' or, as Naik, Lekien & Ross (2017) print it, ''...''.
  std::string single_quoted() {
    std::string_view mark = "'";
    if (rest_.starts_with("''") && rest_.find("''", 2) != std::string_view::npos) mark = "''";
    const std::size_t end = rest_.find(mark, mark.size());
    if (end == std::string_view::npos) unterminated();
    const std::string_view text = take(end + mark.size());
    return std::string(text.substr(mark.size(), end - mark.size()));
  }

  std::string group(char close) {
    const std::size_t end = rest_.find(close);
    if (end == std::string_view::npos) unterminated();
    return std::string(take(end + 1));
  }

  std::string_view rest_;
  const SourceLocation& location_;
};

std::size_t count_of(const std::string& key, const std::string& value, const SourceLocation& location) {
  std::size_t count = 0;
  const char* const end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, count);
  if (stop != end || error != std::errc{}) location.fail(key + "=" + value + ": expected a count");
  return count;
}

void read_attribute(const std::string& key, const std::string& value, const SourceLocation& location,
                    TecplotZone& zone) {
  const auto is = [&key](std::initializer_list<std::string_view> keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  const auto refuse = [&](const std::string& reason) { location.fail(key + "=" + value + ": " + reason); };
  if (is({"T"})) {
    zone.title = value;
  } else if (is({"I", "N", "NODES"})) {
    zone.counts.push_back({key, count_of(key, value, location), location.line});
  } else if (is({"J", "K"})) {
    if (count_of(key, value, location) != 1) refuse("expected one line of points, " + key + "=1");
  } else if (is({"F", "DATAPACKING"})) {
    if (upper(value) != "POINT") refuse("not supported, write the zone as " + key + "=POINT");
  } else if (is({"ZONETYPE"})) {
    if (upper(value) != "ORDERED") refuse("not supported, expected ORDERED");
  } else if (is({"E", "ELEMENTS", "VARSHARELIST"})) {
    refuse("not supported");
  }
}

}  // namespace

TecplotRecord tecplot_record(std::string_view line) {
  const std::string nowhere;  // the functions used here do not fail
  const SourceLocation location{nowhere, 0};
  Scanner scanner(line, location);
  const std::string key = scanner.key();
  if (key == "ZONE") {
    // ZONE alone may be the name of a column.
    const std::string_view rest = scanner.rest();
    return rest.empty() || is_blank(rest.front()) ? TecplotRecord::zone : TecplotRecord::none;
  }
  constexpr std::array<std::string_view, 3> auxiliary{"DATASETAUXDATA", "VARAUXDATA", "AUXDATA"};
  if (std::find(auxiliary.begin(), auxiliary.end(), key) != auxiliary.end()) return TecplotRecord::ignored;
  if (!scanner.more() || !scanner.take('=')) return TecplotRecord::none;
  if (key == "TITLE") return TecplotRecord::title;
  if (key == "VARIABLES") return TecplotRecord::variables;
  return key == "FILETYPE" ? TecplotRecord::ignored : TecplotRecord::none;
}

std::vector<std::string> variable_names(std::string_view line, const SourceLocation& location) {
  Scanner scanner(line, location);
  if (tecplot_record(line) == TecplotRecord::variables) {
    scanner.key();
    scanner.more();
    scanner.take('=');
  }
  std::vector<std::string> names;
  while (scanner.more(true)) names.push_back(scanner.value());
  return names;
}

std::vector<std::string> first_variable_names(std::string_view text, const std::string& path) {
  std::vector<std::string> names;
  bool is_open = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_blanks(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '#') continue;
    const TecplotRecord record = tecplot_record(line);
    const bool ends = record == TecplotRecord::none ? !is_open || (has_number(line) && line.front() != '"')
                                                    : record == TecplotRecord::zone || is_open;
    if (ends) break;
    is_open = is_open || record == TecplotRecord::variables;
    if (!is_open) continue;
    const std::vector<std::string> more = variable_names(line, {path, number});
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}

void read_zone_attributes(std::string_view line, const SourceLocation& location, TecplotZone& zone) {
  Scanner scanner(line, location);
  if (tecplot_record(line) == TecplotRecord::zone) scanner.key();
  while (scanner.more(true)) {
    const std::string_view before = scanner.rest();
    const std::string key = scanner.key();
    if (key.empty() || !scanner.more() || !scanner.take('=')) {
      location.fail("expected KEY=VALUE in a ZONE record, found " + quoted_text(before));
    }
    scanner.more();
    read_attribute(key, scanner.value(), location, zone);
  }
}

std::string tecplot_title(std::string_view title) {
  std::string text = "\"";
  for (const char c : title) {
    if (c == '"' || c == '\\') text += '\\';
    // A line break would end the record.
    text += c == '\n' ? ' ' : c;
  }
  return text + '"';
}

}  // namespace lober::detail
