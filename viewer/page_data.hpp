// The data of a page: an object of JSON that says what there is, and the series of numbers that it refers to.
#pragma once

#include <string>
#include <vector>

#include "viewer/scene.hpp"

namespace lober::viewer {

struct PageData {
  std::string json;                 ///< the object, with no character that could end a script
  std::vector<std::string> series;  ///< parts of series, in base64, by the numbers that the object has
};

/// The object, read by viewer/page/scene.js:
///
///   title, notes   texts
///   deflated       whether series are in the form of zlib
///   rounded        whether points of long curves are rounded away from crossings
///   layers         kind, name, one, colour, width, shown, and by kind
///     lines        curves: name, closed, n, at; perhaps iterates
///     areas        names, columns, n, rings (of each area), runs (of each ring), curve, first, last (of each run)
///     dots         names, columns, points: n, at
///   pool           n, at: points of areas that are on no curve; as a curve it has the number after the last one
///
/// "at" is the number of the first part of a series; parts have 65536 values or points. Where the series of exact
/// points take more than `max_size` bytes, points are rounded to 2^-50 of the size of their curve, but not those at
/// crossings nor those of short curves.
[[nodiscard]] PageData page_data(const Scene& scene, std::size_t max_size);

}  // namespace lober::viewer
