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

std::vector<std::string_view> fields_of(std::string_view line) {
  const char* p = line.data();
  const char* const end = p + line.size();
  const auto take = [&](const char* from, const char* to) {
    return std::string_view(from, static_cast<std::size_t>(to - from));
  };
  std::vector<std::string_view> fields;
  bool after_separator = false;
  for (p = skip_blanks(p, end); (p != end && *p != '#') || after_separator; p = skip_blanks(p, end)) {
    const char* const begin = p;
    if (p != end && *p == '"') {
      while (++p != end && *p != '"') {
      }
      fields.push_back(take(begin + 1, p));
      if (p != end) ++p;
    } else {
      while (p != end && !is_blank(*p) && !is_separator(*p) && *p != '#') ++p;
      fields.push_back(take(begin, p));
    }
    p = skip_blanks(p, end);
    after_separator = p != end && is_separator(*p);
    if (after_separator) ++p;
  }
  return fields;
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

std::string parse_point_line(std::string_view line, Point& point) {
  const std::vector<std::string_view> fields = fields_of(line);
  std::size_t columns = fields.size();
  for (std::size_t i = 0; i < fields.size() && i < 2; ++i) {
    if (fields[i].empty()) {
      if (fields.size() == 2) --columns;
      continue;
    }
    switch (parse_number(fields[i], i == 0 ? point.x : point.y)) {
      case NumberKind::finite:
        break;
      case NumberKind::not_a_number:
        return "not a number: " + quoted_text(fields[i]);
      case NumberKind::not_finite:
        return "not a finite number: " + quoted_text(fields[i]);
    }
  }
  if (columns == 2) return {};
  std::string error = "expected two columns, found " + std::to_string(columns);
  if (line.find(';') != line.npos && line.find(',') != line.npos) {
    error += "; commas separate columns here, and decimals begin with a point";
  }
  return error;
}

bool has_number(std::string_view line) {
  double ignored = 0;
  for (const std::string_view field : fields_of(line)) {
    if (!field.empty() && parse_number(field, ignored) != NumberKind::not_a_number) return true;
  }
  return false;
}

namespace {

// "nan" in any case, with a sign or without.
bool is_nan(std::string_view token) {
  if (!token.empty() && (token.front() == '-' || token.front() == '+')) token.remove_prefix(1);
  const auto is = [&](std::size_t k, char lower) { return token[k] == lower || token[k] == lower - 'a' + 'A'; };
  return token.size() == 3 && is(0, 'n') && is(1, 'a') && is(2, 'n');
}

// A line that parts two curves: both coordinates are NaN, or empty where there are other columns.
bool is_gap(const std::vector<std::string_view>& fields, const TextColumns& columns) {
  if (fields.size() != columns.count) return false;
  const std::string_view x = fields[columns.x], y = fields[columns.y];
  return (is_nan(x) && is_nan(y)) || (!columns.are_all() && x.empty() && y.empty());
}

// A line with more columns than the two that are wanted. Returns its fault, or an empty string.
std::string parse_wide_line(const std::vector<std::string_view>& fields, const TextColumns& columns, Point& point) {
  if (fields.size() != columns.count) {
    return "expected " + std::to_string(columns.count) + " columns, as in the first line, found " +
           std::to_string(fields.size());
  }
  for (const bool second : {false, true}) {
    const std::string_view field = fields[second ? columns.y : columns.x];
    switch (parse_number(field, second ? point.y : point.x)) {
      case NumberKind::finite:
        break;
      case NumberKind::not_a_number:
        return "not a number: " + quoted_text(field);
      case NumberKind::not_finite:
        return "not a finite number: " + quoted_text(field);
    }
  }
  return {};
}

// The lines of a chunk, one after the other.
class ChunkReader {
 public:
  ChunkReader(TextChunk& chunk, const TextColumns& columns) : chunk_(chunk), columns_(columns) {}

  // False at a line that cannot be read.
  bool take(std::string_view line) {
    if (line.empty()) {
      const bool again = !chunk_.others.empty() && chunk_.others.back().kind == OtherLine::Kind::blank &&
                         chunk_.others.back().points_before == chunk_.points.size();
      if (!again) note(OtherLine::Kind::blank, line);
      return true;
    }
    if (line.front() == '#') return true;
    if (columns_.are_all()) return take_two(line);
    const std::vector<std::string_view> fields = fields_of(line);
    if (is_gap(fields, columns_)) return note(OtherLine::Kind::gap, line);
    Point point;
    std::string message = parse_wide_line(fields, columns_, point);
    if (!message.empty()) {
      // A header or a record is for whoever joins the chunks; so is whether there may be one here.
      if (!has_number(line) || line.front() == '>') return note(OtherLine::Kind::text, line);
      return fail(std::move(message));
    }
    if (columns_.group && (!group_ || *group_ != fields[*columns_.group])) {
      group_ = fields[*columns_.group];
      note(OtherLine::Kind::group, *group_);
    }
    chunk_.points.push_back(point);
    return true;
  }

 private:
  bool take_two(std::string_view line) {
    Point point;
    if (!begins_number(line.front())) {
      const bool gap = (line.front() == 'n' || line.front() == 'N') && is_gap(fields_of(line), columns_);
      return note(gap ? OtherLine::Kind::gap : OtherLine::Kind::text, line);
    }
    std::string message = parse_point_line(line, point);
    if (message.empty()) {
      chunk_.points.push_back(point);
      return true;
    }
    if (is_gap(fields_of(line), columns_)) return note(OtherLine::Kind::gap, line);
    return fail(std::move(message));
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
    p = skip_blanks(p, end);
    Point point;
    const char* line_end = nullptr;
    if (fast && p != end && begins_number(*p)) line_end = parse_fast(p, end, point);
    if (line_end != nullptr) {
      chunk.points.push_back(point);
    } else {
      line_end = p == end ? end : static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
      if (line_end == nullptr) line_end = end;
      if (!reader.take({p, static_cast<std::size_t>(line_end - p)})) return;
    }
    ++chunk.lines;
    p = line_end == end ? end : line_end + 1;
  }
}

}  // namespace lober::detail
