#include "engine/curve/scaled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace lober {
namespace {

constexpr std::array members{&Areas::c1,          &Areas::c2,          &Areas::intersection,        &Areas::unite,
                             &Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::symmetric_difference};

}  // namespace

int comfortable_exponent(const Box& box) {
  constexpr int comfortable = 400;
  int size = 0;
  for (const double lane : box.lane) size = std::max(size, std::abs(lane) == 0 ? 0 : std::ilogb(lane));
  const int extent = box.extent() == 0 ? 0 : std::ilogb(box.extent());
  return size > comfortable ? -size : extent < -comfortable ? -extent : 0;
}

std::vector<Point> scaled(const CurveView& curve, int exponent) {
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

void scale(Areas& areas, int exponent) {
  for (double Areas::*const member : members) areas.*member = std::ldexp(areas.*member, exponent);
}

void allow_for_underflow(Areas& bounds) {
  for (double Areas::*const member : members) bounds.*member += std::numeric_limits<double>::denorm_min();
}

}  // namespace lober
