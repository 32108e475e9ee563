// Cases from the public trackers of polygon libraries: pairs of polygons whose overlay some library got wrong.
//
// A case is a file of tests/corpus/trackers: lines of comment `# key: value` with the polygons as they stand in the
// thread, in well-known text, and their exact areas; then both as closed curves in the zones C1 and C2, which lober
// reads. The lines up to B are written by hand, the rest by the program tracker_corpus.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/point.hpp"

namespace lober::trust {

/// A closed ring of vertices; the last one joins the first and does not repeat it.
using Ring = std::vector<Point>;
/// The outer ring, then the holes.
using PolygonRings = std::vector<Ring>;
using Shape = std::vector<PolygonRings>;

enum : std::size_t { area_c1, area_c2, area_c1_minus_c2, area_c2_minus_c1, area_intersection, area_union, area_count };
inline constexpr std::array<std::string_view, area_count> area_names{"c1",          "c2",           "c1_minus_c2",
                                                                     "c2_minus_c1", "intersection", "union"};

struct TrackerCase {
  std::string name;  ///< of the file, without its ending
  std::string tracker, link;
  std::string reported;   ///< the complaint, in a few words
  std::string operation;  ///< one of area_names: the overlay that the complaint is about
  std::string note;       ///< empty, or the remark that readers need
  bool integers = false;  ///< the thread has them as integers
  Shape a, b;
  std::array<std::string, area_count> areas;  ///< exact, to 30 digits; empty where the file has none yet
  std::string hand_written;                   ///< the lines up to B
  std::string text;                           ///< the whole file
};

/// POLYGON or MULTIPOLYGON. Throws std::invalid_argument for anything else.
[[nodiscard]] Shape read_wkt(std::string_view text);

/// The shape as one closed curve. A single ring stays as it is. Several, outer ones counter-clockwise and holes
/// clockwise, are joined by ways from the first vertex of the first ring to the first vertex of each other one and
/// back, which have no area: the curve winds once about every point inside.
[[nodiscard]] std::vector<Point> joined(const Shape& shape);

/// Throws std::invalid_argument with the name of the file where it cannot be read as a case.
[[nodiscard]] TrackerCase read_tracker_case(const std::filesystem::path& file);

/// All cases of a folder by name.
[[nodiscard]] std::vector<TrackerCase> tracker_cases(const std::filesystem::path& folder);

}  // namespace lober::trust
