#include "engine/files/text_columns.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "engine/files/geographic.hpp"
#include "engine/files/number.hpp"
#include "engine/files/source_location.hpp"
#include "engine/files/tecplot.hpp"

namespace lober::detail {
namespace {

// The first lines of a table.
struct FirstLines {
  std::vector<std::string_view> names;   // in the header, or in the last comment before the points
  std::vector<std::string_view> fields;  // in the first line with numbers
  std::size_t line = 0;                  // its number, counted from 1; 0 if there is none
  bool has_decimal_commas = false;
  bool is_tecplot = false;
};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Whether commas are those of decimals: "1,5 2,5" or "1,5;2,5". Between other separators there is nothing but numbers,
// some of which have a comma inside.
bool has_decimal_commas(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::size_t fields = 0;
  bool found = false;
  while (!line.empty()) {
    const std::size_t size = std::min(line.find_first_of("; \t\r"), line.size());
    std::string field(line.substr(0, size));
    line.remove_prefix(std::min(size + 1, line.size()));
    if (field.empty()) continue;
    ++fields;
    const std::size_t comma = field.find(',');
    if (comma == 0 || comma + 1 == field.size()) return false;
    if (comma != std::string::npos) {
      found = true;
      field[comma] = '.';
    }
    double ignored = 0;
    if (parse_number(field, ignored) == NumberKind::not_a_number) return false;
  }
  return found && fields > 1;
}

FirstLines first_lines_of(std::string_view text) {
  FirstLines found;
  bool has_header = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_blanks(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '>') continue;
    if (line.front() == '#') {
      if (!has_header) found.names = fields_of(line.substr(std::min(line.find_first_not_of('#'), line.size())));
      continue;
    }
    if (tecplot_record(line) != TecplotRecord::none) {
      found.is_tecplot = true;
      return found;
    }
    if (has_number(line)) {
      found.fields = fields_of(line);
      found.line = number;
      found.has_decimal_commas = has_decimal_commas(line);
      return found;
    }
    if (has_header) return found;  // whoever reads the lines says what is wrong with this one
    found.names = fields_of(line);
    has_header = true;
  }
  return found;
}

bool same_name(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

std::string joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

// A choice among the columns of a table.
class Choice {
 public:
  Choice(const FirstLines& lines, const std::string& path) : lines_(lines), path_(path) {}

  [[nodiscard]] TextColumns columns(std::string_view choice) const {
    TextColumns columns;
    columns.count = lines_.fields.size();
    std::vector<std::size_t> coordinates;
    for (std::string_view rest = choice; coordinates.size() < 4;) {
      const std::size_t comma = rest.find(',');
      const std::string_view one = without_blanks(rest.substr(0, comma));
      if (one.starts_with("by=")) {
        columns.group = column(one.substr(3));
      } else {
        coordinates.push_back(column(one));
      }
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    if (coordinates.size() != 2) {
      fail("two columns are chosen by \"NAME,NAME\" or \"NUMBER,NUMBER\", not by \"" + std::string(choice) + "\"");
    }
    columns.x = coordinates[0];
    columns.y = coordinates[1];
    return columns;
  }

 private:
  // By its number, counted from 1, or by its name.
  [[nodiscard]] std::size_t column(std::string_view choice) const {
    const bool has_names = lines_.names.size() == lines_.fields.size();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), number);
    if (error == std::errc{} && end == choice.data() + choice.size()) {
      if (number >= 1 && number <= lines_.fields.size()) return number - 1;
    } else if (has_names) {
      for (const bool exact : {true, false}) {
        for (std::size_t k = 0; k < lines_.names.size(); ++k) {
          if (exact ? lines_.names[k] == choice : same_name(lines_.names[k], choice)) return k;
        }
      }
    }
    fail("has no column " + quoted_text(choice) + "; " +
         (has_names ? "its columns are " + joined(lines_.names)
                    : "it has " + std::to_string(lines_.fields.size()) + " columns without names"));
  }

  [[noreturn]] void fail(const std::string& message) const { throw DataError(path_ + ": " + message); }

  const FirstLines& lines_;
  const std::string& path_;
};

// Whether the first two names are those of coordinates.
bool begins_with_coordinates(const std::vector<std::string_view>& names) {
  if (names.size() < 2) return false;
  if (same_name(names[0], "x") && same_name(names[1], "y")) return true;
  return latitude_first(std::string(names[0]) + "," + std::string(names[1])) == false;
}

}  // namespace

TableHead read_table_head(std::string_view text, std::string_view choice, const std::string& path) {
  const FirstLines lines = first_lines_of(text);
  TableHead head;
  if (lines.is_tecplot) {
    if (!choice.empty()) throw DataError(path + ": columns are chosen of tables, not of Tecplot files");
    return head;
  }
  const std::size_t count = lines.fields.size();
  if (lines.has_decimal_commas && (count > 2 || !choice.empty())) {
    SourceLocation{path, lines.line}.fail(
        "commas separate columns here, and decimals begin with a point; write the numbers with points, as sed "
        "'s/,/./g' "
        "does");
  }
  if (!choice.empty()) {
    if (lines.line == 0) throw DataError(path + ": no points");
    head.columns = Choice(lines, path).columns(choice);
  } else if (count > 2 && begins_with_coordinates(lines.names) && lines.names.size() == count) {
    head.columns.count = count;
    if (count == 3 && lines.names[2] == "curve") head.columns.group = 2;  // as lober writes several curves
  } else if (count > 2) {
    std::string message = "expected two columns, found " + std::to_string(count);
    const bool has_all =
        std::none_of(lines.fields.begin(), lines.fields.end(), [](auto field) { return field.empty(); });
    if (lines.names.size() == count) {
      message += ": " + joined(lines.names) + "; choose two by FILE:NAME,NAME";
    } else if (has_all) {
      message += "; choose two by FILE:NUMBER,NUMBER";
    }
    SourceLocation{path, lines.line}.fail(message);
  }
  if (!head.columns.are_all() && lines.names.size() == count) {
    head.names = std::string(lines.names[head.columns.x]) + "," + std::string(lines.names[head.columns.y]);
  }
  return head;
}

}  // namespace lober::detail
