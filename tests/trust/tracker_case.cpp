#include "tests/trust/tracker_case.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "kernels/predicates.hpp"

namespace lober::trust {
namespace {

// Well-known text, character by character.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  Shape shape() {
    Shape result;
    if (take_word("MULTIPOLYGON")) {
      list([&] { result.push_back(polygon()); });
    } else if (take_word("POLYGON")) {
      result.push_back(polygon());
    } else {
      fail("POLYGON or MULTIPOLYGON");
    }
    skip_blanks();
    if (!text_.empty()) fail("the end");
    return result;
  }

 private:
  PolygonRings polygon() {
    PolygonRings rings;
    list([&] { rings.push_back(ring()); });
    return rings;
  }

  Ring ring() {
    Ring points;
    list([&] {
      const double x = number();
      points.push_back({x, number()});
    });
    if (points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (points.size() < 3) fail("a ring of three points");
    return points;
  }

  template <class Element>
  void list(const Element& element) {
    take('(');
    do element();
    while (take_if(','));
    take(')');
  }

  double number() {
    skip_blanks();
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc()) fail("a number");
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }

  bool take_word(std::string_view word) {
    skip_blanks();
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  bool take_if(char wanted) {
    skip_blanks();
    if (text_.empty() || text_.front() != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }
  void take(char wanted) {
    if (!take_if(wanted)) fail(std::string(1, wanted));
  }
  void skip_blanks() { text_.remove_prefix(std::min(text_.find_first_not_of(' '), text_.size())); }
  [[noreturn]] void fail(const std::string& wanted) const {
    throw std::invalid_argument("not " + wanted + ": " + std::string(text_.substr(0, 20)));
  }

  std::string_view text_;
};

// The turn at the lowest vertex on the left, where a simple ring turns its own way.
bool is_counter_clockwise(const Ring& ring) {
  const auto less = [](Point p, Point q) { return p.x < q.x || (p.x == q.x && p.y < q.y); };
  const auto lowest = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), less) - ring.begin());
  const std::size_t n = ring.size();
  PredicateCounts counts;
  return detail::orient2d(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n], counts) > 0;
}

std::string value_of(const std::string& line, std::string_view key) {
  const std::string begin = "# " + std::string(key) + ": ";
  return line.starts_with(begin) ? line.substr(begin.size()) : std::string();
}

}  // namespace

Shape read_wkt(std::string_view text) {
  return WktReader(text).shape();
}

std::vector<Point> joined(const Shape& shape) {
  if (shape.size() == 1 && shape.front().size() == 1) return shape.front().front();
  std::vector<Point> curve;
  for (const PolygonRings& polygon : shape) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      Ring ring = polygon[k];
      if (is_counter_clockwise(ring) != (k == 0)) std::reverse(ring.begin() + 1, ring.end());
      const bool first = curve.empty();
      curve.insert(curve.end(), ring.begin(), ring.end());
      curve.push_back(ring.front());
      if (!first) curve.push_back(curve.front());
    }
  }
  curve.pop_back();  // the curve closes itself
  return curve;
}

TrackerCase read_tracker_case(const std::filesystem::path& file) {
  TrackerCase result;
  result.name = file.stem();
  std::ifstream stream(file);
  std::stringstream whole;
  whole << stream.rdbuf();
  result.text = whole.str();
  std::string line;
  try {
    while (std::getline(whole, line) && line.starts_with("#")) {
      for (const auto& [key, value] : {std::pair{"tracker", &result.tracker},
                                       {"link", &result.link},
                                       {"reported", &result.reported},
                                       {"operation", &result.operation},
                                       {"note", &result.note}}) {
        if (const std::string found = value_of(line, key); !found.empty()) *value = found;
      }
      if (value_of(line, "coordinates") == "integers") result.integers = true;
      for (std::size_t k = 0; k < area_count; ++k) {
        const std::string found = value_of(line, "area " + std::string(area_names[k]));
        if (!found.empty()) result.areas[k] = found;
      }
      if (const std::string found = value_of(line, "A"); !found.empty()) result.a = read_wkt(found);
      if (result.b.empty()) result.hand_written += line + "\n";
      if (const std::string found = value_of(line, "B"); !found.empty()) result.b = read_wkt(found);
    }
    if (result.tracker.empty() || result.link.empty() || result.reported.empty()) {
      throw std::invalid_argument("tracker, link or reported is missing");
    }
    if (std::find(area_names.begin(), area_names.end(), result.operation) == area_names.end()) {
      throw std::invalid_argument("not an operation: " + result.operation);
    }
    if (result.a.empty() || result.b.empty()) throw std::invalid_argument("A or B is missing");
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(file.string() + ": " + error.what());
  }
  return result;
}

std::vector<TrackerCase> tracker_cases(const std::filesystem::path& folder) {
  std::vector<TrackerCase> cases;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".dat") cases.push_back(read_tracker_case(entry.path()));
  }
  std::sort(cases.begin(), cases.end(), [](const auto& p, const auto& q) { return p.name < q.name; });
  return cases;
}

}  // namespace lober::trust
