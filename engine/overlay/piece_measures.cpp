// Centroids of pieces, and which pieces are only noise.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/overlay/boundary.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
namespace {

// First moments and twice the area of a closed polygon about `origin`.
struct Moments {
  DD area, x, y;
  void add(const std::vector<Point>& polygon, Point origin) {
    DD before_x = two_diff(polygon.back().x, origin.x), before_y = two_diff(polygon.back().y, origin.y);
    for (const Point& p : polygon) {
      const DD here_x = two_diff(p.x, origin.x), here_y = two_diff(p.y, origin.y);
      const DD term = cross(before_x, before_y, here_x, here_y);
      area += term;
      x += term * (before_x + here_x);
      y += term * (before_y + here_y);
      before_x = here_x;
      before_y = here_y;
    }
  }
};

double length(const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], &b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

double largest_coordinate(const CurveView& curve) {
  double largest = 0;
  for (const Point& p : curve.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

// An upper bound on the length of a segment of the curve.
double longest_segment(const CurveView& curve) {
  double longest = 0;
  for (std::uint32_t k = 0; k < curve.segments(); ++k) {
    const auto [a, b] = curve.segment(k);
    longest = std::max(longest, std::fabs(b.x - a.x) + std::fabs(b.y - a.y));
  }
  return longest;
}

}  // namespace

std::vector<Point> centroids(const Overlay& result, Pairing pairing) {
  const std::size_t count = result.pieces(pairing).size();
  std::vector<Point> points(count);
  for_each_block(count, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::vector<std::vector<Point>> polygons = outline(result, pairing, k);
      const Point origin = polygons[0][0];
      Moments moments;
      for (const std::vector<Point>& polygon : polygons) moments.add(polygon, origin);
      const DD below = DD{3, 0} * moments.area;
      if (below.hi == 0) {  // a piece so thin that its rounded vertices enclose nothing
        points[k] = origin;
      } else {
        points[k] = {origin.x + (moments.x / below).hi, origin.y + (moments.y / below).hi};
      }
    }
  });
  return points;
}

Slivers find_slivers(const Overlay& result, Pairing pairing) {
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const double ulp = std::max(largest_coordinate(c1), largest_coordinate(c2)) * std::numeric_limits<double>::epsilon();
  const double longest = std::max(longest_segment(c1), longest_segment(c2));
  const double vertices = static_cast<double>(c1.points.size() + c2.points.size());
  Slivers slivers;
  const std::span<const double> areas = result.pieces(pairing).areas();
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (areas[k] > 2 * ulp * longest * vertices) continue;
    // A piece between few nodes has few segments, mostly; only then is its outline worth walking.
    double perimeter = 0;
    for (const std::vector<Point>& polygon : outline(result, pairing, k)) perimeter += length(polygon);
    if (areas[k] > 2 * ulp * perimeter) continue;
    slivers.pieces.push_back(static_cast<std::uint32_t>(k));
    slivers.area += areas[k];
  }
  return slivers;
}

}  // namespace lober
