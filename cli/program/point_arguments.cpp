#include "cli/program/point_arguments.hpp"

#include <cmath>
#include <optional>

#include "cli/program/option_parser.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

std::optional<Point> point_of(const char* option, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const std::optional<double> x = number_of(text.substr(0, comma)), y = number_of(text.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  if (!std::isfinite(*x) || !std::isfinite(*y)) {
    throw UsageError(std::string(option) + ": " + text + " is not a finite point");
  }
  return Point{*x, *y};
}

}  // namespace

std::vector<std::string> point_files(const char* option, const std::vector<std::string>& texts) {
  std::vector<std::string> files;
  for (const std::string& text : texts) {
    if (!point_of(option, text)) files.push_back(text);
  }
  return files;
}

Buffer<Point> points_of(const char* option, const std::vector<std::string>& texts, const Curve* beside) {
  Buffer<Point> points;
  for (const std::string& text : texts) {
    if (const std::optional<Point> point = point_of(option, text)) {
      points.push_back(*point);
      continue;
    }
    const CurveFile file = read_curves(text, {.hash = false});
    if (beside) {
      Curve columns;
      columns.name = text;
      columns.latitude_first = latitude_first(file);
      require_same_columns(*beside, columns);
    }
    for (const Zone& zone : file.zones) {
      points.insert(points.end(), zone.points.begin(), zone.points.end());
    }
  }
  return points;
}

}  // namespace lober::cli
