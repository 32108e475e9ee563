// Boost.Geometry on polygons of doubles, or of integers where the thread has them.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>
#include <exception>
#include <type_traits>

#include "bench/trackers/rival_program.hpp"

namespace lober::bench {
namespace {

namespace bg = boost::geometry;
template <class Number>
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<Number>>;
template <class Number>
using BoostPolygons = bg::model::multi_polygon<BoostPolygon<Number>>;

template <class Number>
BoostPolygons<Number> polygons_of(const trust::Shape& shape) {
  BoostPolygons<Number> polygons;
  for (const trust::PolygonRings& rings : shape) {
    BoostPolygon<Number> polygon;
    polygon.inners().resize(rings.size() - 1);
    for (std::size_t k = 0; k < rings.size(); ++k) {
      auto& ring = k == 0 ? polygon.outer() : polygon.inners()[k - 1];
      for (const Point& point : rings[k]) ring.emplace_back(static_cast<Number>(point.x), static_cast<Number>(point.y));
    }
    polygons.push_back(polygon);
  }
  bg::correct(polygons);  // orientation and closing points, as it wants them
  return polygons;
}

template <class Number, class Overlay>
RivalOverlay measured(const Overlay& overlay) {
  RivalOverlay result;
  try {
    BoostPolygons<Number> pieces;
    overlay(pieces);
    result.area = bg::area(pieces, bg::strategy::area::cartesian<double>());
    result.valid = bg::is_valid(pieces);
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  return result;
}

template <class Number, class Geometry>
RivalAnswer overlays_of(const Geometry& a, const Geometry& b) {
  RivalAnswer answer;
  answer.grid = std::is_integral_v<Number> ? 1 : 0;
  if (!bg::is_valid(a, answer.invalid_input) || !bg::is_valid(b, answer.invalid_input)) {
    if (answer.invalid_input.empty()) answer.invalid_input = "not valid";
  } else {
    answer.invalid_input.clear();
  }
  answer.overlays = {measured<Number>([&](auto& out) { bg::difference(a, b, out); }),
                     measured<Number>([&](auto& out) { bg::difference(b, a, out); }),
                     measured<Number>([&](auto& out) { bg::intersection(a, b, out); }),
                     measured<Number>([&](auto& out) { bg::union_(a, b, out); })};
  return answer;
}

template <class Number>
RivalAnswer boost_overlays(const trust::Shape& a, const trust::Shape& b) {
  const BoostPolygons<Number> first = polygons_of<Number>(a), second = polygons_of<Number>(b);
  if (first.size() == 1 && second.size() == 1) return overlays_of<Number>(first.front(), second.front());
  return overlays_of<Number>(first, second);
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  std::string version = BOOST_LIB_VERSION;
  version.replace(version.find('_'), 1, ".");
  return lober::bench::run_rival_program({arguments, static_cast<std::size_t>(count)}, "Boost " + version,
                                         lober::bench::boost_overlays<double>, lober::bench::boost_overlays<int>);
}
