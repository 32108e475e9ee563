#include "engine/curve/scaling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lober {

int scaling_exponent(const Box& box) {
  constexpr int comfortable = 400;
  int size = 0;
  for (const double lane : box.lane) size = std::max(size, std::abs(lane) == 0 ? 0 : std::ilogb(lane));
  const int extent = box.extent() == 0 ? 0 : std::ilogb(box.extent());
  return size > comfortable ? -size : extent < -comfortable ? -extent : 0;
}

std::vector<Point> scaled_points(CurveView curve, int exponent) {
  std::vector<Point> points;
  points.reserve(curve.points.size());
  for (const Point& p : curve.points) {
    const Point q{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    if (!(Point{std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent)} == p)) {
      throw DataError("coordinates range too widely: an area in double precision cannot span them");
    }
    points.push_back(q);
  }
  return points;
}

}  // namespace lober
