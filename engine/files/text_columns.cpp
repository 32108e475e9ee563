#include "engine/files/text_columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include "engine/files/column_choice.hpp"
#include "engine/files/geographic.hpp"
#include "engine/files/number.hpp"
#include "engine/files/source_location.hpp"
#include "engine/files/tecplot.hpp"

namespace lober::detail {
namespace {

// The first lines of a table.
struct FirstLines {
  std::vector<std::string> names;       // in the header, or in the last comment before the points
  std::vector<std::string_view> cells;  // in the first line with numbers
  Separator separator = Separator::blanks;
  std::size_t line = 0;     // number of the first line with numbers, counted from 1; 0 if there is none
  std::size_t skipped = 0;  // bytes of a line that names the separator
  bool has_decimal_commas = false;
  std::size_t pairs = 0;  // more than two pairs of numbers with commas, which blanks part; 0 for other lines
  bool is_tecplot = false;
};

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

// The number of pairs in a line of several points, "0,0 1,0 1,1", which looks as one of decimals with commas does. Two
// of them are taken for x and y, and as many as the header has names for its columns.
std::size_t pairs_in(std::string_view line, std::string_view header) {
  constexpr std::size_t least = 3;
  line = line.substr(0, line.find('#'));
  if (line.find(';') != std::string_view::npos) return 0;
  std::size_t pairs = 0;
  while (!line.empty()) {
    const std::size_t size = std::min(line.find_first_of(" \t\r"), line.size());
    const std::string_view field = line.substr(0, size);
    line.remove_prefix(std::min(size + 1, line.size()));
    if (field.empty()) continue;
    if (field.find(',') == std::string_view::npos) return 0;
    ++pairs;
  }
  return pairs < least || pairs == cells_of(header, Separator::blanks).size() ? 0 : pairs;
}

// Takes the next line of `text`.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

// The separator that a line "sep=;" names, as Excel writes and reads it.
std::optional<Separator> named_separator(std::string_view line, const std::string& path) {
  while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (!line.starts_with("sep=") && !line.starts_with("SEP=")) return std::nullopt;
  const std::string_view name = line.substr(4);
  if (name == ",") return Separator::comma;
  if (name == ";") return Separator::semicolon;
  if (name == "\t" || name == "\\t") return Separator::tab;
  SourceLocation{path, 1}.fail("the separator " + quoted_text(name) +
                               " is not known; it is a comma, a semicolon or a tab");
}

// Whether a separator parts the header and a line with numbers into the same cells. Tabs that leave a cell empty in
// both align columns.
bool parts_both(Separator separator, std::string_view header, std::string_view line) {
  const std::vector<std::string_view> names = cells_of(header, separator),
                                      cells = cells_of(line, separator, names.size());
  if (names.size() < 2 || names.size() != cells.size()) return false;
  for (const auto* const line_cells : {&names, &cells}) {
    if (std::any_of(line_cells->begin(), line_cells->end(), goes_on_behind_quotes)) return false;
  }
  for (std::size_t k = 0; separator == Separator::tab && k < cells.size(); ++k) {
    if (names[k].empty() && cells[k].empty()) return false;
  }
  return true;
}

// The names in a line, which may have other separators than the numbers.
std::vector<std::string> names_in(std::string_view line, Separator separator, std::size_t count) {
  std::vector<std::string_view> cells = cells_of(line, separator);
  if (cells.size() != count) cells = cells_of(line, Separator::blanks);
  std::vector<std::string> names;
  names.reserve(cells.size());
  for (const std::string_view cell : cells) names.push_back(text_of_cell(cell));
  return names;
}

// Reads the line with numbers, and decides on the separator unless one is named.
void read_numbers(std::string_view line, std::string_view header, std::string_view comment,
                  std::optional<Separator> named, FirstLines& found) {
  constexpr std::array candidates{Separator::comma, Separator::semicolon, Separator::tab};
  const auto* const both = std::find_if(candidates.begin(), candidates.end(),
                                        [&](Separator separator) { return parts_both(separator, header, line); });
  found.separator = named ? *named : both != candidates.end() ? *both : separator_of(line);
  const bool is_tab = found.separator == Separator::tab;
  const std::string_view cut = is_tab ? line : without_blanks(line);
  std::size_t columns = 1;
  if (named || both != candidates.end()) columns = cells_of(header, found.separator).size();
  found.cells = cells_of(cut, found.separator, columns);
  const bool commas_part = named == Separator::comma || (!named && both == candidates.begin());
  found.has_decimal_commas = !commas_part && has_decimal_commas(without_blanks(line));
  if (found.has_decimal_commas) found.pairs = pairs_in(line, header);
  found.names = names_in(header.empty() ? comment : header, found.separator, found.cells.size());
  // The names of rows have none, as R writes them.
  if (!header.empty() && found.names.size() + 1 == found.cells.size()) found.names.insert(found.names.begin(), "");
}

// Whether all cells of a line are empty: it parts curves, and is neither a header nor units.
bool has_no_values(std::string_view line) {
  return line.find_first_not_of(",;\"\t ") == std::string_view::npos;
}

FirstLines first_lines_of(std::string_view text, const std::string& path) {
  FirstLines found;
  std::string_view header, comment;
  std::string_view rest = text;
  bool has_units = false;  // a line of them below the header, as ERDDAP has it
  const std::optional<Separator> named = named_separator(next_line(rest), path);
  if (named) found.skipped = text.size() - rest.size();
  if (!named) rest = text;
  for (std::size_t number = named ? 2 : 1; !rest.empty(); ++number) {
    const std::string_view whole = next_line(rest), line = without_blanks(whole);
    if (line.empty() || line.front() == '>') continue;
    if (line.front() == '#') {
      comment = line.substr(std::min(line.find_first_not_of('#'), line.size()));
      continue;
    }
    if (tecplot_record(line) != TecplotRecord::none) {
      found.is_tecplot = true;
      return found;
    }
    if (named ? has_number(whole, *named) : has_number(line)) {
      found.line = number;
      read_numbers(whole, header, comment, named, found);
      return found;
    }
    if (is_open(cells_of(line, named.value_or(Separator::comma)).back())) {
      SourceLocation{path, number}.fail("quotes do not end on their line: " + quoted_text(line));
    }
    if (has_no_values(line)) continue;
    const Separator separator = named.value_or(separator_of(header));
    const bool are_units = !header.empty() && !has_units && cells_of(whole, separator).size() > 2 &&
                           cells_of(whole, separator).size() == cells_of(header, separator).size();
    has_units = has_units || are_units;
    if (are_units) continue;
    if (!header.empty()) return found;  // whoever reads the lines says what is wrong with this one
    header = whole;
  }
  return found;
}

bool same_name(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() || name.empty() ? "" : ", ") + name;
  return text;
}

// A choice among columns.
class Choice {
 public:
  // `names` where each of the `count` columns has one.
  Choice(const std::vector<std::string>& names, std::size_t count, const std::string& path)
      : names_(names), count_(count), path_(path) {}

  void choose(std::string_view choice, TextColumns& columns) const {
    columns.count = count_;
    std::vector<std::size_t> coordinates;
    for (const ChoicePart& part : parts_of_choice(choice)) {
      if (part.key == "by") {
        columns.group = column(part.name);
      } else {
        coordinates.push_back(column(part.whole()));
      }
    }
    if (coordinates.size() != 2) {
      fail("two columns are chosen by \"NAME,NAME\" or \"NUMBER,NUMBER\", not by \"" + std::string(choice) + "\"");
    }
    columns.x = coordinates[0];
    columns.y = coordinates[1];
  }

 private:
  // By its number, counted from 1, or by its name.
  [[nodiscard]] std::size_t column(std::string_view choice) const {
    const bool has_names = names_.size() == count_;
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), number);
    if (error == std::errc{} && end == choice.data() + choice.size()) {
      if (number >= 1 && number <= count_) return number - 1;
    } else if (has_names) {
      for (const bool exact : {true, false}) {
        for (std::size_t k = 0; k < names_.size(); ++k) {
          if (exact ? names_[k] == choice : same_name(names_[k], choice)) return k;
        }
      }
    }
    fail("has no column " + quoted_text(choice) + "; " +
         (has_names ? "its columns are " + joined(names_)
                    : "it has " + std::to_string(count_) + " columns without names"));
  }

  [[noreturn]] void fail(const std::string& message) const { throw DataError(path_ + ": " + message); }

  const std::vector<std::string>& names_;
  std::size_t count_;
  const std::string& path_;
};

// Whether the first two names are those of coordinates.
bool begins_with_coordinates(const std::vector<std::string>& names) {
  if (names.size() < 2) return false;
  if (same_name(names[0], "x") && same_name(names[1], "y")) return true;
  return latitude_first(names[0] + "," + names[1]) == false;
}

void choose_variables(const std::vector<std::string>& names, std::string_view choice, const std::string& path,
                      TableHead& head) {
  if (!choice.empty()) {
    if (names.empty())
      throw DataError(path + ": this Tecplot file has no VARIABLES record, whose names choose columns");
    Choice(names, names.size(), path).choose(choice, head.columns);
    if (head.columns.group) throw DataError(path + ": zones part the curves of Tecplot files, not a column");
  } else if (names.size() > 2 && begins_with_coordinates(names)) {
    head.columns.count = names.size();
  }
  if (!head.columns.are_all()) head.names = names[head.columns.x] + "," + names[head.columns.y];
}

}  // namespace

TableHead read_table_head(std::string_view text, std::string_view choice, const std::string& path) {
  const FirstLines lines = first_lines_of(text, path);
  TableHead head;
  head.skipped = lines.skipped;
  head.columns.is_tecplot = lines.is_tecplot;
  head.columns.separator = lines.separator;
  if (lines.is_tecplot) {
    choose_variables(first_variable_names(text, path), choice, path, head);
    return head;
  }
  const std::size_t count = lines.cells.size();
  if (lines.pairs > 0) {
    SourceLocation{path, lines.line}.fail("this line has " + std::to_string(lines.pairs) +
                                          " pairs of numbers; each point needs a line of its own, as tr -s "
                                          "'[:blank:]' '\\n' makes it; decimals begin with a point");
  }
  if (lines.has_decimal_commas) {
    SourceLocation{path, lines.line}.fail(
        "commas separate columns here, and decimals begin with a point; write the numbers with points, as sed "
        "'s/,/./g' "
        "does");
  }
  if (!choice.empty()) {
    if (lines.line == 0) throw DataError(path + ": no points");
    Choice(lines.names, count, path).choose(choice, head.columns);
  } else if (count > 2 && begins_with_coordinates(lines.names) && lines.names.size() == count) {
    head.columns.count = count;
    if (count == 3 && lines.names[2] == "curve") head.columns.group = 2;  // as lober writes several curves
  } else if (count > 2) {
    std::string message = "expected two columns, found " + std::to_string(count);
    const bool has_all = std::none_of(lines.cells.begin(), lines.cells.end(), [](auto field) { return field.empty(); });
    if (lines.names.size() == count) {
      message += ": " + joined(lines.names) + "; choose two by FILE:NAME,NAME";
    } else if (has_all) {
      message += "; choose two by FILE:NUMBER,NUMBER";
    }
    SourceLocation{path, lines.line}.fail(message);
  }
  if (!head.columns.are_all() && lines.names.size() == count) {
    head.names = lines.names[head.columns.x] + "," + lines.names[head.columns.y];
  }
  return head;
}

}  // namespace lober::detail
