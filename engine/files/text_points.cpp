#include "engine/files/text_points.hpp"

#include <charconv>
#include <cmath>
#include <cstring>

#include "engine/files/number.hpp"

namespace lober::detail {
namespace {

// '\r' is a blank: with the line break of DOS it stands at the end of the line.
constexpr bool is_separator(char c) {
  return c == ',' || c == ';';
}
constexpr bool begins_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '+';
}

const char* skip_blanks(const char* p, const char* end) {
  while (p != end && is_blank(*p)) ++p;
  return p;
}

/// The common shape of a line, as fast as the numbers can be read: blanks, number, blanks or one separator,
/// number, blanks, line end. Returns the line end, or nullptr when the line has another shape or cannot be
/// read.
const char* parse_fast(const char* p, const char* end, Point& point) {
  const auto [after_x, error_x] = std::from_chars(p, end, point.x);
  if (error_x != std::errc{}) return nullptr;
  p = skip_blanks(after_x, end);
  if (p != end && is_separator(*p)) p = skip_blanks(p + 1, end);
  // Without anything between them these would be one token, such as 1.5-2.
  if (p == after_x) return nullptr;
  const auto [after_y, error_y] = std::from_chars(p, end, point.y);
  if (error_y != std::errc{}) return nullptr;
  p = skip_blanks(after_y, end);
  if (p != end && *p != '\n') return nullptr;
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return nullptr;
  return p;
}

}  // namespace

std::string parse_point_line(std::string_view line, Point& point) {
  const std::vector<std::string_view> cells = cells_of(line, Separator::blanks);
  std::size_t columns = cells.size();
  for (std::size_t i = 0; i < cells.size() && i < 2; ++i) {
    const std::string_view cell = inside_quotes(cells[i]);
    if (cell.empty()) {
      if (cells.size() == 2) --columns;
      continue;
    }
    switch (parse_number(cell, i == 0 ? point.x : point.y)) {
      case NumberKind::finite:
        break;
      case NumberKind::not_a_number:
        return "not a number: " + quoted_text(cell);
      case NumberKind::not_finite:
        return "not a finite number: " + quoted_text(cell);
    }
  }
  if (columns == 2) return {};
  std::string error = "expected two columns, found " + std::to_string(columns);
  if (line.find(';') != line.npos && line.find(',') != line.npos) {
    error += "; commas separate columns here, and decimals begin with a point";
  }
  return error;
}

namespace {

// "nan" in any case, with a sign or without.
bool is_nan(std::string_view token) {
  if (!token.empty() && (token.front() == '-' || token.front() == '+')) token.remove_prefix(1);
  const auto is = [&](std::size_t k, char lower) { return token[k] == lower || token[k] == lower - 'a' + 'A'; };
  return token.size() == 3 && is(0, 'n') && is(1, 'a') && is(2, 'n');
}

// A line that parts two curves: both coordinates are NaN, or empty.
bool is_gap(const std::vector<std::string_view>& cells, const TextColumns& columns) {
  if (cells.size() != columns.count) return false;
  const std::string_view x = inside_quotes(cells[columns.x]), y = inside_quotes(cells[columns.y]);
  return (is_nan(x) && is_nan(y)) || (!columns.is_tecplot && x.empty() && y.empty());
}

// A line with more columns than the two that are wanted. Returns its fault, or an empty string.
std::string parse_wide_line(const std::vector<std::string_view>& cells, const TextColumns& columns, Point& point) {
  if (cells.size() != columns.count) {
    return "expected " + std::to_string(columns.count) + " columns, " +
           (columns.is_tecplot ? "one for each variable" : "as in the first line") + ", found " +
           std::to_string(cells.size());
  }
  for (const bool second : {false, true}) {
    const std::string_view cell = inside_quotes(cells[second ? columns.y : columns.x]);
    switch (parse_number(cell, second ? point.y : point.x)) {
      case NumberKind::finite:
        break;
      case NumberKind::not_a_number:
        return "not a number: " + quoted_text(cell);
      case NumberKind::not_finite:
        return "not a finite number: " + quoted_text(cell);
    }
  }
  return {};
}

// The lines of a chunk, one after the other.
class ChunkReader {
 public:
  ChunkReader(TextChunk& chunk, const TextColumns& columns) : chunk_(chunk), columns_(columns) {}

  // `line` begins behind the blanks of `whole`. False at a line that cannot be read.
  bool take(std::string_view line, std::string_view whole) {
    if (line.empty()) {
      const bool again = !chunk_.others.empty() && chunk_.others.back().kind == OtherLine::Kind::blank &&
                         chunk_.others.back().points_before == chunk_.points.size();
      if (!again) note(OtherLine::Kind::blank, line);
      return true;
    }
    if (line.front() == '#') return true;
    if (line.front() == '>') return note(OtherLine::Kind::text, line);
    return columns_.are_all() ? take_two(line) : take_wide(line, whole);
  }

 private:
  bool take_two(std::string_view line) {
    const bool is_quoted = line.front() == '"' && !columns_.is_tecplot;
    Point point;
    if (!begins_number(line.front()) && !is_quoted) {
      const bool may_be_gap = line.front() == 'n' || line.front() == 'N' || is_separator(line.front());
      const bool gap = may_be_gap && is_gap(cut(line), columns_);
      return note(gap ? OtherLine::Kind::gap : OtherLine::Kind::text, line);
    }
    std::string message = parse_point_line(line, point);
    if (message.empty()) {
      chunk_.points.push_back(point);
      return true;
    }
    if (is_gap(cut(line), columns_)) return note(OtherLine::Kind::gap, line);
    return is_quoted ? note(OtherLine::Kind::text, line) : fail(std::move(message));
  }
  bool take_wide(std::string_view line, std::string_view whole) {
    if (columns_.is_tecplot && !begins_number(line.front())) return note(OtherLine::Kind::text, line);
    cut_into_cells(columns_.separator == Separator::tab ? whole : line, columns_.separator, columns_.count, cells_);
    if (is_gap(cells_, columns_)) return note(OtherLine::Kind::gap, line);
    Point point;
    if (!cells_.empty() && is_open(cells_.back())) {
      return fail("quotes do not end on their line: " + quoted_text(cells_.back()));
    }
    std::string message = parse_wide_line(cells_, columns_, point);
    if (!message.empty()) {
      // A header or a record is for whoever joins the chunks; so is whether there may be one here.
      if (!has_number(line, columns_.separator)) return note(OtherLine::Kind::text, line);
      return fail(std::move(message));
    }
    if (columns_.group && (!group_ || *group_ != cells_[*columns_.group])) {
      group_ = cells_[*columns_.group];
      note(OtherLine::Kind::group, *group_);
    }
    chunk_.points.push_back(point);
    return true;
  }
  const std::vector<std::string_view>& cut(std::string_view line) {
    cut_into_cells(line, Separator::blanks, 2, cells_);
    return cells_;
  }
  bool note(OtherLine::Kind kind, std::string_view text) {
    chunk_.others.push_back({kind, text, chunk_.lines, chunk_.points.size()});
    return true;
  }
  bool fail(std::string message) {
    chunk_.error = LineError{chunk_.lines, std::move(message)};
    return false;
  }

  TextChunk& chunk_;
  const TextColumns& columns_;
  std::optional<std::string_view> group_;
  std::vector<std::string_view> cells_;  // those of the last line, whose memory is used again
};

}  // namespace

void parse_chunk(TextChunk& chunk, const TextColumns& columns) {
  chunk.points.clear();
  chunk.others.clear();
  chunk.lines = 0;
  chunk.error.reset();
  ChunkReader reader(chunk, columns);
  const bool fast = columns.are_all();
  const char* p = chunk.text.data();
  const char* const end = p + chunk.text.size();
  while (p != end) {
    const char* const begin = p;
    p = skip_blanks(p, end);
    Point point;
    const char* line_end = nullptr;
    if (fast && p != end && begins_number(*p)) line_end = parse_fast(p, end, point);
    if (line_end != nullptr) {
      chunk.points.push_back(point);
    } else {
      line_end = p == end ? end : static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
      if (line_end == nullptr) line_end = end;
      const auto until_end = [&](const char* from) {
        return std::string_view(from, static_cast<std::size_t>(line_end - from));
      };
      if (!reader.take(until_end(p), until_end(begin))) return;
    }
    ++chunk.lines;
    p = line_end == end ? end : line_end + 1;
  }
}

}  // namespace lober::detail
