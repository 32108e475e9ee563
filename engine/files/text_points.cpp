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

/// Cuts a line into fields at blanks, or at a comma or semicolon with any blanks around it. A separator at
/// the beginning or the end, or two in a row, leave an empty field. A '#' ends the line.
std::vector<std::string_view> fields_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  const char* p = line.data();
  const char* const end = p + line.size();
  std::vector<std::string_view> fields;
  bool after_separator = false;
  for (p = skip_blanks(p, end); p != end || after_separator; p = skip_blanks(p, end)) {
    const char* const begin = p;
    while (p != end && !is_blank(*p) && !is_separator(*p)) ++p;
    fields.emplace_back(begin, static_cast<std::size_t>(p - begin));
    p = skip_blanks(p, end);
    after_separator = p != end && is_separator(*p);
    if (after_separator) ++p;
  }
  return fields;
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

void parse_chunk(TextChunk& chunk) {
  chunk.points.clear();
  chunk.others.clear();
  chunk.lines = 0;
  chunk.error.reset();
  const char* p = chunk.text.data();
  const char* const end = p + chunk.text.size();
  while (p != end) {
    p = skip_blanks(p, end);
    Point point;
    const char* line_end = nullptr;
    if (p != end && begins_number(*p)) line_end = parse_fast(p, end, point);
    if (line_end != nullptr) {
      chunk.points.push_back(point);
    } else {
      line_end = p == end ? end : static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
      if (line_end == nullptr) line_end = end;
      const std::string_view line(p, static_cast<std::size_t>(line_end - p));
      if (line.empty() || line.front() == '#') {
        // nothing on this line
      } else if (!begins_number(line.front())) {
        chunk.others.push_back({line, chunk.lines, chunk.points.size()});
      } else if (std::string message = parse_point_line(line, point); message.empty()) {
        chunk.points.push_back(point);
      } else {
        chunk.error = LineError{chunk.lines, std::move(message)};
        return;
      }
    }
    ++chunk.lines;
    p = line_end == end ? end : line_end + 1;
  }
}

}  // namespace lober::detail
