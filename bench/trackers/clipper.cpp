// Clipper 6, which takes integers of 64 bits: coordinates that are integers, times 2^20, so that crossings are rounded
// to millionths.
#include <cmath>
#include <exception>
#include <polyclipping/clipper.hpp>

#include "bench/trackers/rival_program.hpp"

namespace lober::bench {
namespace {

constexpr double units = 1 << 20;

bool has_integers(const trust::Shape& shape) {
  for (const trust::PolygonRings& polygon : shape) {
    for (const trust::Ring& ring : polygon) {
      for (const Point& point : ring) {
        if (point.x != std::round(point.x) || point.y != std::round(point.y)) return false;
      }
    }
  }
  return true;
}

ClipperLib::Paths paths_of(const trust::Shape& shape) {
  ClipperLib::Paths paths;
  for (const trust::PolygonRings& polygon : shape) {
    for (const trust::Ring& ring : polygon) {
      ClipperLib::Path path;
      for (const Point& point : ring) {
        path.emplace_back(static_cast<ClipperLib::cInt>(point.x * units),
                          static_cast<ClipperLib::cInt>(point.y * units));
      }
      paths.push_back(path);
    }
  }
  return paths;
}

RivalOverlay overlay(const ClipperLib::Paths& a, const ClipperLib::Paths& b, ClipperLib::ClipType type) {
  RivalOverlay result;
  try {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(a, ClipperLib::ptSubject, true);
    clipper.AddPaths(b, ClipperLib::ptClip, true);
    ClipperLib::Paths pieces;
    if (!clipper.Execute(type, pieces, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd)) result.error = "no result";
    for (const ClipperLib::Path& piece : pieces) result.area += ClipperLib::Area(piece) / (units * units);
    result.valid = true;  // it has no check of its own
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  return result;
}

RivalAnswer clipper_overlays(const trust::Shape& a, const trust::Shape& b) {
  RivalAnswer answer;
  answer.grid = 1 / units;
  answer.taken = has_integers(a) && has_integers(b);
  if (!answer.taken) return answer;
  const ClipperLib::Paths first = paths_of(a), second = paths_of(b);
  answer.overlays = {overlay(first, second, ClipperLib::ctDifference), overlay(second, first, ClipperLib::ctDifference),
                     overlay(first, second, ClipperLib::ctIntersection), overlay(first, second, ClipperLib::ctUnion)};
  return answer;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  return lober::bench::run_rival_program({arguments, static_cast<std::size_t>(count)}, "Clipper " CLIPPER_VERSION,
                                         lober::bench::clipper_overlays, nullptr);
}
