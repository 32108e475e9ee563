#include "engine/files/text_cells.hpp"

#include <algorithm>

#include "engine/files/number.hpp"

namespace lober::detail {
namespace {

constexpr char character_of(Separator separator) {
  switch (separator) {
    case Separator::tab:
      return '\t';
    case Separator::comma:
      return ',';
    case Separator::semicolon:
      return ';';
    default:
      return ' ';
  }
}

std::string_view between(const char* from, const char* to) {
  return {from, static_cast<std::size_t>(to - from)};
}

// Behind the quote that ends the text which begins at `p` with one; the end of the line where none does.
const char* behind_quotes(const char* p, const char* end) {
  for (++p; p != end; ++p) {
    if (*p != '"') continue;
    if (p + 1 == end || p[1] != '"') return p + 1;
    ++p;
  }
  return end;
}

bool is_number(std::string_view cell) {
  double ignored = 0;
  return parse_number(inside_quotes(cell), ignored) != NumberKind::not_a_number;
}

void cut_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  const auto parts = [](char c) { return c == ',' || c == ';'; };
  const char* p = line.data();
  const char* const end = p + line.size();
  const auto skip_blanks = [&] {
    while (p != end && is_blank(*p)) ++p;
  };
  bool after_separator = false;
  for (skip_blanks(); (p != end && *p != '#') || after_separator; skip_blanks()) {
    const char* const begin = p;
    if (p != end && *p == '"') {
      p = behind_quotes(p, end);
    } else {
      while (p != end && !is_blank(*p) && !parts(*p) && *p != '#') ++p;
    }
    cells.push_back(between(begin, p));
    skip_blanks();
    after_separator = p != end && parts(*p);
    if (after_separator) ++p;
  }
}

void cut_at(char separator, std::string_view line, std::size_t count, std::vector<std::string_view>& cells) {
  const char* p = line.data();
  const char* const end = p + line.size();
  const auto begins_comment = [&](const char* begin, const char* at) {
    if (cells.size() + 1 < count || at == line.data() || !is_blank(at[-1])) return false;
    const std::string_view before = without_blanks(between(begin, at));
    return before.empty() || before.front() == '"' || is_number(before);
  };
  for (;; ++p) {
    while (p != end && is_blank(*p) && *p != separator) ++p;
    const char* const begin = p;
    if (p != end && *p == '"') p = behind_quotes(p, end);
    bool ends = false;
    while (p != end && *p != separator && !ends) {
      ends = *p == '#' && begins_comment(begin, p);
      if (!ends) ++p;
    }
    const std::string_view cell = without_blanks(between(begin, p));
    // A tab before a comment is one of the blanks before it.
    if (!ends || !cell.empty() || separator != '\t') cells.push_back(cell);
    if (ends || p == end) return;
  }
}

bool has_empty_cell(const std::vector<std::string_view>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); });
}

// The line up to a comment: behind numbers alone, or behind a blank where there is a number before.
std::string_view before_comment(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    const std::string_view before = line.substr(0, at);
    const std::vector<std::string_view> cells = cells_of(before, Separator::blanks);
    const bool all = std::all_of(cells.begin(), cells.end(), is_number);
    if (all || (is_blank(line[at - 1]) && std::any_of(cells.begin(), cells.end(), is_number))) return before;
  }
  return line;
}

// Whether a character is there outside of quotes that begin a cell.
bool has_outside_quotes(std::string_view line, char wanted) {
  const char* p = line.data();
  const char* const end = p + line.size();
  for (bool begins = true; p != end;) {
    if (*p == wanted) return true;
    if (*p == '"' && begins) {
      p = behind_quotes(p, end);
      begins = true;  // "x""y" are two
      continue;
    }
    begins = is_blank(*p) || *p == ',' || *p == ';';
    ++p;
  }
  return false;
}

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void cut_into_cells(std::string_view line, Separator separator, std::size_t count,
                    std::vector<std::string_view>& cells) {
  cells.clear();
  separator == Separator::blanks ? cut_at_blanks(line, cells) : cut_at(character_of(separator), line, count, cells);
}

std::vector<std::string_view> cells_of(std::string_view line, Separator separator, std::size_t count) {
  std::vector<std::string_view> cells;
  cut_into_cells(line, separator, count, cells);
  return cells;
}

std::string_view inside_quotes(std::string_view cell) {
  if (cell.empty() || cell.front() != '"') return cell;
  cell.remove_prefix(1);
  if (!cell.empty() && cell.back() == '"') cell.remove_suffix(1);
  return without_blanks(cell);
}

std::string text_of_cell(std::string_view cell) {
  std::string text(inside_quotes(cell));
  if (cell.empty() || cell.front() != '"') return text;
  for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1)) text.erase(at, 1);
  return text;
}

bool goes_on_behind_quotes(std::string_view cell) {
  const char* const end = cell.data() + cell.size();
  return cell.starts_with('"') && behind_quotes(cell.data(), end) != end;
}

bool is_open(std::string_view cell) {
  if (cell.empty() || cell.front() != '"') return false;
  const char* const end = cell.data() + cell.size();
  if (behind_quotes(cell.data(), end) != end) return false;
  // An even number of quotes, the first one included, ends them.
  return std::count(cell.begin(), cell.end(), '"') % 2 != 0;
}

Separator separator_of(std::string_view line) {
  line = before_comment(line);
  Separator first = Separator::blanks;
  for (const Separator separator : {Separator::comma, Separator::semicolon, Separator::tab}) {
    if (!has_outside_quotes(line, character_of(separator))) continue;
    const std::vector<std::string_view> cells = cells_of(line, separator);
    if (separator == Separator::tab && has_empty_cell(cells)) continue;
    if (std::any_of(cells.begin(), cells.end(), is_number)) return separator;
    if (first == Separator::blanks) first = separator;
  }
  return first;
}

bool has_number(std::string_view line, Separator separator) {
  const std::vector<std::string_view> cells = cells_of(line, separator);
  if (std::any_of(cells.begin(), cells.end(), is_number)) return true;
  if (separator == Separator::blanks) return false;
  const std::vector<std::string_view> all = cells_of(line, Separator::blanks);
  return !all.empty() && std::all_of(all.begin(), all.end(), is_number);
}

bool has_number(std::string_view line) {
  return has_number(line, separator_of(line));
}

std::string quoted_text(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return result + (text.size() > longest ? "...\"" : "\"");
}

}  // namespace lober::detail
