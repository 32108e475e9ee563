// Boost.Geometry on polygons of doubles.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <exception>

#include "bench/rivals/rival.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, /*ClockWise=*/false, /*Closed=*/true>;
using BoostPieces = bg::model::multi_polygon<BoostPolygon>;

BoostPolygon polygon_of(std::span<const Point> points) {
  BoostPolygon polygon;
  polygon.outer().reserve(points.size() + 1);
  for (const Point& point : points) polygon.outer().emplace_back(point.x, point.y);
  polygon.outer().push_back(polygon.outer().front());
  return polygon;
}

}  // namespace

RivalResult run_boost(std::span<const Point> first, std::span<const Point> second) {
  const BoostPolygon a = polygon_of(first);
  const BoostPolygon b = polygon_of(second);
  RivalResult result;
  BoostPieces pieces[4];
  try {
    const Stopwatch all;
    bg::difference(a, b, pieces[0]);
    bg::difference(b, a, pieces[1]);
    const Stopwatch intersection;
    bg::intersection(a, b, pieces[2]);
    result.intersection_seconds = intersection.seconds();
    bg::union_(a, b, pieces[3]);
    result.seconds = all.seconds();
  } catch (const std::exception& error) {
    result.note = error.what();
    return result;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    result.areas[k] = bg::area(pieces[k]);
    result.pieces[k] = pieces[k].size();
  }
  result.ran = true;
  return result;
}

}  // namespace lober::bench
