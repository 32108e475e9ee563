// The things that a page shows: layers of lines, areas and dots, with numbers about each.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lober/curve/curve.hpp"

namespace lober::viewer {

/// Numbers of the areas or dots of a layer, one each; NaN where it is not known.
struct Column {
  std::string name;              ///< "area"
  std::vector<double> values;    ///< one of each area or dot
  std::vector<double> bar = {};  ///< error bars; empty without
};

/// A curve of a layer of lines. The points stay where they are until the page is written.
struct Line {
  std::string name;  ///< name of the curve
  CurveView curve;   ///< points in the order of the engine, so that numbers of points agree
  /// Segments near which it is stored exactly however many points there are: those with crossings.
  std::vector<std::uint32_t> exact = {};
};

using Polygons = std::vector<std::vector<Point>>;  ///< rings of one area, filled by the nonzero rule

/// One kind of thing, with one form and one switch.
struct Layer {
  enum class Kind : std::uint8_t {
    lines,     ///< curves
    areas,     ///< filled polygons
    outlines,  ///< polygons that are not filled
    dots       ///< points
  };
  Kind kind = Kind::lines;
  std::string name = {};    ///< "U, unstable manifold"
  std::string one = {};     ///< name of one of them, for those without a name of their own: "lobe"
  std::string colour = {};  ///< "#rrggbb"
  double width = 1.2;       ///< of lines, or radius of dots, in pixels
  bool shown = true;        ///< at first
  std::vector<Line> lines = {};
  std::vector<Polygons> areas = {};  ///< areas, outlines
  std::vector<Point> dots = {};
  std::vector<std::string> names = {};  ///< of areas or dots; empty: `one` and a number
  std::vector<Column> columns = {};     ///< numbers about areas or dots
  /// Number of the column that counts iterates, which can be played through; -1 without. Of lines: `iterates`.
  int iterate_column = -1;
  std::vector<int> iterates = {};  ///< of each line; empty without

  [[nodiscard]] std::size_t size() const {
    return kind == Kind::lines ? lines.size() : kind == Kind::dots ? dots.size() : areas.size();
  }
};

/// All of a page.
struct Scene {
  std::string title;               ///< "Tangle of two manifolds"
  std::vector<std::string> notes;  ///< sentences about the result: where it comes from, agreement, total areas
  std::vector<Layer> layers;       ///< the first is at the bottom
  std::vector<std::shared_ptr<const void>> owners = {};  ///< keep points alive
};

}  // namespace lober::viewer
