#include "engine/geometry/curve/scaled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace lober::detail {
namespace {

constexpr std::array area_members{&Areas::c1,          &Areas::c2,          &Areas::intersection,        &Areas::union_,
                                  &Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::symmetric_difference};

}  // namespace

int scaling_exponent(const Box& box) {
  constexpr int max_exponent = 300;  // centroids take products of three lengths, parameters of crossings those too
  int size = 0;
  for (const double lane : box.lane) size = std::max(size, std::abs(lane) == 0 ? 0 : std::ilogb(lane));
  const int extent = box.extent() == 0 ? 0 : std::ilogb(box.extent());
  return size > max_exponent ? -size : extent < -max_exponent ? -extent : 0;
}

std::vector<Point> scaled(const CurveView& curve, int exponent) {
  std::vector<Point> points;
  points.reserve(curve.points.size());
  for (const Point& p : curve.points) {
    const Point q{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    if (!(Point{std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent)} == p)) {
      throw DataError(
          "coordinates range too widely for products in double precision; leave out the smallest or the largest ones");
    }
    points.push_back(q);
  }
  return points;
}

double scaled_area(double area, int exponent) {
  const double result = std::ldexp(area, exponent);
  if (!std::isfinite(result)) {
    throw DataError("an area is larger than the largest double, 1.8e308; give coordinates in a larger unit");
  }
  return result;
}

void scale(Areas& areas, int exponent) {
  for (double Areas::*const member : area_members) areas.*member = scaled_area(areas.*member, exponent);
}

double scaled_bound(double bound, int exponent) {
  return std::min(std::ldexp(bound, exponent) + std::numeric_limits<double>::denorm_min(),
                  std::numeric_limits<double>::max());
}

void require_known(double area, double bound) {
  if (area != 0 || bound < std::numeric_limits<double>::max()) return;
  throw DataError(
      "an area may be larger than the largest double, 1.8e308, or zero: it is lost in the rounding of a curve that is "
      "much larger; give curves of more equal size, or coordinates in a larger unit");
}

void scale_bounds(const Areas& areas, Areas& bounds, int exponent) {
  for (double Areas::*const member : area_members) {
    bounds.*member = scaled_bound(bounds.*member, exponent);
    require_known(areas.*member, bounds.*member);
  }
}

}  // namespace lober::detail
