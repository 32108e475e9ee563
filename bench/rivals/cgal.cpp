// CGAL's regularised Boolean operations over its exact kernel: slow, and right. Its areas are the reference
// of the table.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <exception>
#include <iterator>
#include <vector>

#include "bench/rivals/rival.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPolygon = CGAL::Polygon_2<Kernel>;
using ExactPiece = CGAL::Polygon_with_holes_2<Kernel>;

ExactPolygon polygon_of(std::span<const Point> points) {
  ExactPolygon polygon;
  for (const Point& point : points) polygon.push_back(Kernel::Point_2(point.x, point.y));
  return polygon;
}

double area_of(const std::vector<ExactPiece>& pieces) {
  Kernel::FT area = 0;
  for (const ExactPiece& piece : pieces) {
    area += piece.outer_boundary().area();
    for (auto hole = piece.holes_begin(); hole != piece.holes_end(); ++hole) area += hole->area();
  }
  return CGAL::to_double(CGAL::exact(area));
}

}  // namespace

RivalResult run_cgal(std::span<const Point> first, std::span<const Point> second) {
  const ExactPolygon a = polygon_of(first);
  const ExactPolygon b = polygon_of(second);
  RivalResult result;
  std::vector<ExactPiece> pieces[4];
  try {
    const Stopwatch all;
    CGAL::difference(a, b, std::back_inserter(pieces[0]));
    CGAL::difference(b, a, std::back_inserter(pieces[1]));
    const Stopwatch intersection;
    CGAL::intersection(a, b, std::back_inserter(pieces[2]));
    result.intersection_seconds = intersection.seconds();
    ExactPiece joined;
    if (CGAL::join(a, b, joined)) {
      pieces[3].push_back(joined);
    } else {
      pieces[3].emplace_back(a);
      pieces[3].emplace_back(b);
    }
    result.seconds = all.seconds();
    for (std::size_t k = 0; k < 4; ++k) {
      result.areas[k] = area_of(pieces[k]);
      result.pieces[k] = pieces[k].size();
    }
  } catch (const std::exception& error) {
    result.note = error.what();
    return result;
  }
  result.ran = true;
  return result;
}

}  // namespace lober::bench
