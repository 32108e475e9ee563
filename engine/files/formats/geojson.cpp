// GeoJSON (RFC 7946). nlohmann's library reads it piece by piece.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/json_text.hpp"
#include "engine/base/text.hpp"
#include "engine/base/utf8.hpp"
#include "engine/files/formats/geometry_zones.hpp"
#include "engine/files/formats/provenance.hpp"
#include "engine/files/formats/readers.hpp"
#include "engine/files/sniff.hpp"
#include "lober/base/error.hpp"
#if LOBER_HAS_JSON
#include <nlohmann/json.hpp>
#endif

namespace lober::detail {

#if LOBER_HAS_JSON
namespace {

// The coordinates of a geometry: lists of positions, each with its depth and whether it is the first in its parent: no
// hole.
struct Line {
  std::vector<Point> points;
  std::size_t depth = 0;
  bool first = true;
};

// Takes the parser's events. Objects may have their members in any order, so that zones are made where one ends.
class GeoJsonReader {
 public:
  explicit GeoJsonReader(CurveFile& file) : path_(file.path), zones_(file) {}

  void finish() {
    if (!is_geojson_) {
      throw DataError(path_ +
                      ": is JSON, but not GeoJSON, whose objects have a \"type\"; write its coordinates as two "
                      "columns of text");
    }
    zones_.finish();
  }

  bool start_object(std::size_t) {
    require_no_coordinates("an object");
    const bool is_property = key_ == "properties" || (!objects_.empty() && objects_.back().is_property);
    objects_.push_back({std::exchange(key_, {}), zones_.size(), is_property});
    return true;
  }

  bool key(std::string& name) {
    key_ = name;
    return true;
  }

  bool end_object() {
    const Object object = std::move(objects_.back());
    objects_.pop_back();
    if (object.has_coordinates) add_geometry(object);
    if (object.type == "Feature") zones_.name_from(object.first_zone, object.title);
    const bool properties = object.key == "properties" && !objects_.empty();
    if (properties && !object.title.empty()) objects_.back().title = object.title;  // rather than an id
    return true;
  }

  bool start_array(std::size_t) {
    if (depth_ > 0) {
      begin_list();
    } else if (key_ == "coordinates" && !objects_.empty() && !objects_.back().is_property) {
      objects_.back().has_coordinates = true;
      lines_.clear();
      line_is_open_ = false;
      begin_list();
    }
    key_.clear();
    return true;
  }

  bool end_array() {
    if (depth_ > 0) end_list();
    return true;
  }

  bool string(std::string& value) {
    require_no_coordinates("a text");
    if (objects_.empty()) return true;
    Object& object = objects_.back();
    if (key_ == "type" && !object.is_property) {
      object.type = value;
      is_geojson_ = is_geojson_ || depth_of(value).has_value();
    } else if (key_ == "name" || key_ == "title" || (key_ == "id" && object.title.empty())) {
      object.title = value;
    }
    return true;
  }

  bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return number(value); }
  bool boolean(bool) {
    require_no_coordinates("true or false");
    return true;
  }
  bool null() {
    require_no_coordinates("null");
    return true;
  }
  bool binary(std::vector<std::uint8_t>&) { return true; }

  template <typename Exception>
  bool parse_error(std::size_t, const std::string&, const Exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    const std::string_view what = error.what();
    throw DataError(path_ + ": " + std::string(what.substr(std::min(what.find("] ") + 2, what.size()))));
  }

 private:
  struct Object {
    std::string key;             // whose value it is
    std::size_t first_zone = 0;  // that it adds
    bool is_property = false;    // or inside of one
    std::string type = {}, title = {};
    bool has_coordinates = false;
  };

  static constexpr std::size_t max_depth = 4;  // that of a MultiPolygon

  // How deep the positions of a geometry lie in its coordinates; 0 for collections and points; nothing for types that
  // GeoJSON does not know.
  static std::optional<std::size_t> depth_of(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 9> known{{{"FeatureCollection", 0},
                                                                             {"Feature", 0},
                                                                             {"GeometryCollection", 0},
                                                                             {"Point", 0},
                                                                             {"MultiPoint", 1},
                                                                             {"LineString", 1},
                                                                             {"MultiLineString", 2},
                                                                             {"Polygon", 2},
                                                                             {"MultiPolygon", 3}}};
    const auto* const found =
        std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.first == type; });
    return found == known.end() ? std::nullopt : std::optional(found->second);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(path_ + ": GeoJSON: geometry " + std::to_string(geometries_) + ": " + what);
  }

  void require_no_coordinates(std::string_view what) const {
    if (depth_ > 0) fail("its coordinates hold " + std::string(what));
  }

  void begin_list() {
    if (depth_ == max_depth || numbers_ > 0) fail("its coordinates are no lists of positions");
    counts_[depth_++] = 0;
  }

  void end_list() {
    --depth_;
    if (numbers_ > 0) {  // a position
      if (numbers_ < 2) fail("a position has one number");
      add_position();
    } else if (depth_ > 0) {
      ++counts_[depth_ - 1];
    }
    line_is_open_ = line_is_open_ && depth_ >= line_depth_;
    numbers_ = 0;
  }

  bool number(double value) {
    if (depth_ == 0) {
      if (key_ == "id" && !objects_.empty() && objects_.back().title.empty())
        objects_.back().title = format_number(value);
      return true;
    }
    if (numbers_ < 2) position_[numbers_] = value;
    ++numbers_;
    return true;
  }

  void add_position() {
    if (!line_is_open_ || line_depth_ != depth_) {
      const bool first = depth_ < 2 || counts_[depth_ - 2] == 0;
      lines_.push_back({{}, depth_, first});
      line_is_open_ = true;
      line_depth_ = depth_;
    }
    lines_.back().points.push_back({position_[0], position_[1]});
  }

  void add_geometry(const Object& object) {
    const bool polygon = object.type == "Polygon" || object.type == "MultiPolygon";
    const std::optional<std::size_t> depth = depth_of(object.type);
    if (!depth) fail("its type is \"" + object.type + "\"");
    for (Line& line : lines_) {
      if (line.depth != *depth) fail("its coordinates are not those of a " + object.type);
      if (object.type == "Point") {
        zones_.add_point(line.points.front());
      } else {
        zones_.add_line(std::move(line.points), polygon && !line.first);
      }
    }
    lines_.clear();
    ++geometries_;
  }

  const std::string& path_;
  GeometryZones zones_;
  std::vector<Object> objects_;
  std::string key_;
  std::vector<Line> lines_;
  std::size_t depth_ = 0;                        // lists inside of coordinates
  std::array<std::size_t, max_depth> counts_{};  // lists that ended in each of them
  std::size_t numbers_ = 0;                      // those of the position so far
  std::array<double, 2> position_{};
  std::size_t line_depth_ = 0;
  bool line_is_open_ = false;
  std::size_t geometries_ = 0;
  bool is_geojson_ = false;
};

}  // namespace

void read_geojson(const FileSource& source, CurveFile& file) {
  GeoJsonReader reader(file);
  const std::string_view text = source.text().substr(byte_order_mark(source.bytes));
  nlohmann::json::sax_parse(text.begin(), text.end(), &reader);
  reader.finish();
}
#else
void read_geojson(const FileSource&, CurveFile& file) {
  throw DataError(file.path + ": this is JSON; this lober was built without nlohmann-json3-dev, which reads GeoJSON");
}
#endif

namespace {

// As readers of JSON take -0 for an integer, it is -0.0.
std::string coordinate(double value) {
  return value == 0 && std::signbit(value) ? "-0.0" : format_number(value);
}

void append_position(std::string& text, Point point) {
  text += '[' + coordinate(point.x) + ',' + coordinate(point.y) + ']';
}

// A ring ends with its first point (RFC 7946, 3.1.6).
void append_positions(std::string& text, const Zone& zone, bool closed) {
  text += '[';
  for (const Point& point : zone.points) {
    if (&point != zone.points.data()) text += ',';
    append_position(text, point);
  }
  if (closed && !zone.points.empty()) {
    text += ',';
    append_position(text, zone.points.front());
  }
  text += ']';
}

}  // namespace

std::string geojson_bytes(std::span<const Zone> zones, const WriteOptions& options) {
  std::string text = "{\"type\":\"FeatureCollection\"";
  if (!options.provenance.empty()) {
    text += ",\n\"provenance\":{";
    for (const auto& [key, value] : options.provenance) {
      if (&key != &options.provenance.front().first) text += ',';
      text += json_string(key) + ':' + json_string(as_utf8(value));
    }
    text += '}';
  }
  text += ",\n\"features\":[";
  for (std::size_t k = 0; k < zones.size();) {
    const Zone& zone = zones[k];
    text += k == 0 ? "\n" : ",\n";
    text += "{\"type\":\"Feature\",\"properties\":{";
    if (!zone.title.empty()) text += "\"name\":" + json_string(as_utf8(zone.title));
    for (const auto& [name, number] : zone.numbers) {
      if (text.back() != '{') text += ',';
      text += json_string(name) + ':';
      append_json_number(text, number);
    }
    text += "},\"geometry\":{\"type\":\"";
    const bool closed = is_closed(zone, options);
    text += closed ? "Polygon\",\"coordinates\":[" : "LineString\",\"coordinates\":";
    append_positions(text, zone, closed);
    for (++k; closed && k < zones.size() && zones[k].hole; ++k) {
      text += ',';
      append_positions(text, zones[k], true);
    }
    text += closed ? "]}}" : "}}";
  }
  return text + "\n]}\n";
}

}  // namespace lober::detail
