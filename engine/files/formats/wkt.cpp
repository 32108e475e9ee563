// Well-known text (ISO 19125, OGC 06-103r4): POLYGON ((0 0, 1 0, 1 1, 0 0)), one geometry behind the other.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "engine/base/text.hpp"
#include "engine/files/formats/geometry_zones.hpp"
#include "engine/files/formats/readers.hpp"
#include "engine/files/number.hpp"
#include "engine/files/sniff.hpp"
#include "engine/files/source_location.hpp"
#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

enum class Shape : std::uint8_t { point, line, points, lines, polygon, polygons, collection };

struct Keyword {
  std::string_view word;
  Shape shape;
};
constexpr std::array<Keyword, 8> keywords{{{"POINT", Shape::point},
                                           {"LINESTRING", Shape::line},
                                           {"LINEARRING", Shape::line},
                                           {"MULTIPOINT", Shape::points},
                                           {"MULTILINESTRING", Shape::lines},
                                           {"POLYGON", Shape::polygon},
                                           {"MULTIPOLYGON", Shape::polygons},
                                           {"GEOMETRYCOLLECTION", Shape::collection}}};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string upper_case(std::string_view word) {
  std::string upper(word);
  for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return upper;
}

// Blanks, line ends and comments.
std::string_view without_space(std::string_view text) {
  while (!text.empty()) {
    if (is_blank(text.front()) || text.front() == '\n' || text.front() == ';') {
      text.remove_prefix(1);
    } else if (text.front() == '#') {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else {
      break;
    }
  }
  return text;
}

std::string_view word_at(std::string_view text) {
  return text.substr(0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_letter) - text.begin()));
}

const Keyword* keyword_of(std::string_view word) {
  const std::string upper = upper_case(word);
  const auto* const found =
      std::find_if(keywords.begin(), keywords.end(), [&](const Keyword& one) { return one.word == upper; });
  return found == keywords.end() ? nullptr : found;
}

class WktReader {
 public:
  WktReader(std::string_view text, CurveFile& file) : all_(text), rest_(text), path_(file.path), zones_(file) {}

  void read() {
    for (skip(); !rest_.empty(); skip()) {
      if (take_srid()) continue;
      geometry(0);
    }
    zones_.finish();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    const std::string_view before = all_.substr(0, all_.size() - rest_.size());
    SourceLocation{path_, 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'))}.fail(what);
  }

  void skip() { rest_ = without_space(rest_); }

  bool take(char c) {
    skip();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(std::string("WKT: expected ") + c + " before " + found());
  }

  [[nodiscard]] std::string found() const {
    constexpr std::size_t most = 24;
    return rest_.empty() ? "the end" : quoted_text(rest_.substr(0, std::min(rest_.find('\n'), most)));
  }

  // "SRID=4326;", as PostGIS writes before a geometry.
  bool take_srid() {
    if (upper_case(rest_.substr(0, 5)) != "SRID=") return false;
    rest_.remove_prefix(std::min(rest_.find(';'), rest_.size()));
    return true;
  }

  void geometry(int depth) {
    constexpr int max_depth = 32;
    const std::string_view word = word_at(rest_);
    const Keyword* const keyword = keyword_of(word);
    if (keyword == nullptr) fail("WKT: expected a geometry, such as POLYGON, before " + found());
    if (depth > max_depth) fail("WKT: collections are nested too deep");
    rest_.remove_prefix(word.size());
    skip();
    const std::string_view dimensions = word_at(rest_);
    const std::string upper = upper_case(dimensions);
    if (upper == "Z" || upper == "M" || upper == "ZM") {
      rest_.remove_prefix(dimensions.size());
      skip();
    }
    if (upper_case(word_at(rest_)) == "EMPTY") return rest_.remove_prefix(5);
    shape(keyword->shape, depth);
  }

  void shape(Shape kind, int depth) {
    switch (kind) {
      case Shape::point:
        expect('(');
        zones_.add_point(position());
        return expect(')');
      case Shape::line:
        return zones_.add_line(positions());
      case Shape::points:
        return zones_.add_line(positions_in_any_brackets());
      case Shape::lines:
        return list([&](bool) { zones_.add_line(positions()); });
      case Shape::polygon:
        return polygon();
      case Shape::polygons:
        return list([&](bool) { polygon(); });
      case Shape::collection:
        return list([&](bool) {
          skip();
          geometry(depth + 1);
        });
    }
  }

  template <typename Item>
  void list(const Item& item) {
    expect('(');
    bool first = true;
    do {
      item(first);
      first = false;
    } while (take(','));
    expect(')');
  }

  void polygon() {
    skip();
    if (upper_case(word_at(rest_)) == "EMPTY") return rest_.remove_prefix(5);
    list([&](bool first) { zones_.add_line(positions(), !first); });
  }

  std::vector<Point> positions() {
    skip();
    std::vector<Point> points;
    if (upper_case(word_at(rest_)) == "EMPTY") {
      rest_.remove_prefix(5);
      return points;
    }
    list([&](bool) { points.push_back(position()); });
    return points;
  }

  // MULTIPOINT ((0 0), (1 1)) or, as older programs write it, MULTIPOINT (0 0, 1 1).
  std::vector<Point> positions_in_any_brackets() {
    std::vector<Point> points;
    list([&](bool) {
      const bool bracket = take('(');
      points.push_back(position());
      if (bracket) expect(')');
    });
    return points;
  }

  // Two numbers, and up to two more, which are left out.
  Point position() {
    std::array<double, 4> numbers{};
    std::size_t count = 0;
    for (skip(); !rest_.empty() && rest_.front() != ',' && rest_.front() != ')'; skip()) {
      const std::size_t size = std::min(rest_.find_first_of(" \t\r\n\f\v,()"), rest_.size());
      const std::string_view token = rest_.substr(0, size);
      if (count == numbers.size() || parse_number(token, numbers[count]) != NumberKind::finite) {
        fail("WKT: expected the numbers of a point before " + found());
      }
      ++count;
      rest_.remove_prefix(size);
    }
    if (count < 2) fail("WKT: expected the two numbers of a point before " + found());
    return {numbers[0], numbers[1]};
  }

  std::string_view all_, rest_;
  const std::string& path_;
  GeometryZones zones_;
};

}  // namespace

bool is_wkt(std::string_view text) {
  constexpr std::size_t looked_at = std::size_t{1} << 16;
  text = without_space(text.substr(0, looked_at));
  if (upper_case(text.substr(0, 5)) == "SRID=") return true;
  const std::string_view word = word_at(text);
  if (keyword_of(word) == nullptr) return false;
  // A header of a table may be called so: behind a geometry's name stands a bracket.
  std::string_view behind = without_space(text.substr(word.size()));
  const std::string next = upper_case(word_at(behind));
  if (next == "EMPTY") return true;
  if (next == "Z" || next == "M" || next == "ZM") behind = without_space(behind.substr(next.size()));
  return behind.starts_with('(') || upper_case(word_at(behind)) == "EMPTY";
}

void read_wkt(const FileSource& source, CurveFile& file) {
  WktReader(source.text().substr(byte_order_mark(source.bytes)), file).read();
}

namespace {

void append_ring(std::string& text, const Zone& zone, bool closed) {
  if (zone.points.empty()) {
    text += "EMPTY";
    return;
  }
  text += '(';
  const auto append = [&](Point point) { text += format_number(point.x) + ' ' + format_number(point.y); };
  for (const Point& point : zone.points) {
    if (&point != zone.points.data()) text += ", ";
    append(point);
  }
  if (closed) {
    text += ", ";
    append(zone.points.front());
  }
  text += ')';
}

}  // namespace

std::string wkt_bytes(std::span<const Zone> zones, const WriteOptions& options) {
  std::string text;  // without comments, which the standard does not know
  for (std::size_t k = 0; k < zones.size();) {
    const bool closed = is_closed(zones[k], options), has_brackets = closed && !zones[k].points.empty();
    text += closed ? "POLYGON " : "LINESTRING ";
    if (has_brackets) text += '(';
    append_ring(text, zones[k], closed);
    for (++k; has_brackets && k < zones.size() && zones[k].hole; ++k) {
      text += ", ";
      append_ring(text, zones[k], true);
    }
    text += has_brackets ? ")\n" : "\n";
  }
  return text;
}

}  // namespace lober::detail
