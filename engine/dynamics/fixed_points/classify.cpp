#include "engine/dynamics/fixed_points/classify.hpp"

#include <cmath>

#include "engine/dynamics/maps/plane.hpp"

namespace lober::detail {
namespace {

Point direction(const Matrix2& a, double eigenvalue) {
  const Point first{a.xy, eigenvalue - a.xx};
  const Point second{eigenvalue - a.yy, a.yx};
  Point v = length(first) > length(second) ? first : second;
  const double norm = length(v);
  if (norm == 0) return {1, 0};
  v = {v.x / norm, v.y / norm};
  const bool turn = std::abs(v.x) > 1e-9 ? v.x < 0 : v.y < 0;
  return turn ? Point{-v.x, -v.y} : v;
}

}  // namespace

void classify(FixedPoint& point) {
  const Matrix2& a = point.derivative;
  const double half_trace = 0.5 * (a.xx + a.yy);
  const double det = determinant(a);
  // (trace / 2)^2 - det, without the cancellation of that form.
  const double half_difference = 0.5 * (a.xx - a.yy);
  const double discriminant = half_difference * half_difference + a.xy * a.yx;
  const auto compare_to_1 = [](double modulus) { return std::abs(modulus - 1) <= 1e-7 ? 0 : modulus > 1 ? 1 : -1; };
  if (discriminant < 0) {
    const double imaginary = std::sqrt(-discriminant);
    point.multipliers = {std::complex(half_trace, imaginary), std::complex(half_trace, -imaginary)};
    const int side = compare_to_1(std::sqrt(det));
    point.kind = side == 0 ? FixedPointKind::centre : side > 0 ? FixedPointKind::repelling : FixedPointKind::attracting;
    return;
  }
  const double first = half_trace + std::copysign(std::sqrt(discriminant), half_trace);
  const double second = first != 0 ? det / first : 0;
  point.multipliers = {first, second};
  point.directions = {direction(a, first), direction(a, second)};
  const int larger = compare_to_1(std::abs(first));
  const int smaller = compare_to_1(std::abs(second));
  if (larger == 0 || smaller == 0) {
    point.kind = FixedPointKind::parabolic;
  } else if (larger == smaller) {
    point.kind = larger > 0 ? FixedPointKind::repelling : FixedPointKind::attracting;
  } else if (first * second < 0) {
    point.kind = FixedPointKind::reversing_saddle;
  } else {
    point.kind = first > 0 ? FixedPointKind::saddle : FixedPointKind::inverse_saddle;
  }
}

void classify_degenerate(FixedPoint& point) {
  constexpr double same = 1e-7;
  double other = determinant(point.derivative);
  if (std::abs(other - 1) <= same) other = 1;
  const bool larger = std::abs(other) > 1;
  const double first = larger ? other : 1, second = larger ? 1 : other;
  point.multipliers = {first, second};
  point.directions = {direction(point.derivative, first), direction(point.derivative, second)};
  point.kind = FixedPointKind::parabolic;
}

}  // namespace lober::detail
