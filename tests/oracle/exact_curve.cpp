#include "tests/oracle/exact_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lober::oracle {
namespace {

// The exponent of the lowest set bit; the largest int for zero, which is a multiple of everything.
int lowest_bit(double value) {
  if (value == 0) return std::numeric_limits<int>::max();
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  exponent -= 53;
  for (; mantissa % 2 == 0; mantissa /= 2) ++exponent;
  return exponent;
}

Integer on_grid(double value, int grid) {
  if (value == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Integer result(std::ldexp(fraction, 53));
  const int shift = exponent - 53 - grid;
  if (shift >= 0) return result << static_cast<mp_bitcnt_t>(shift);
  return result >> static_cast<mp_bitcnt_t>(-shift);
}

void set_segments(ExactCurve& curve) {
  const std::size_t count = curve.size();
  curve.dx.resize(count);
  curve.dy.resize(count);
  curve.offset.resize(count);
  curve.twice_area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = curve.after(i);
    curve.dx[i] = curve.x[k] - curve.x[i];
    curve.dy[i] = curve.y[k] - curve.y[i];
    curve.offset[i] = curve.dx[i] * curve.y[i] - curve.dy[i] * curve.x[i];
    curve.twice_area -= curve.offset[i];
  }
}

// Scratch space: the inner loops of the oracles would spend most of their time in malloc.
Integer& scratch() {
  thread_local Integer value;
  return value;
}

bool folds_back(const ExactCurve& curve, std::size_t i) {
  const std::size_t k = curve.after(i);
  return turn(curve, i, curve, k) == 0 && sgn(curve.dx[i] * curve.dx[k] + curve.dy[i] * curve.dy[k]) < 0;
}

bool segments_meet(const ExactCurve& curve, std::size_t i, std::size_t j) {
  if (!boxes_meet(curve, i, curve, j)) return false;
  if (side(curve, i, curve, j) * side(curve, i, curve, curve.after(j)) > 0) return false;
  return side(curve, j, curve, i) * side(curve, j, curve, curve.after(i)) <= 0;
}

}  // namespace

int common_exponent(std::span<const Point> first, std::span<const Point> second) {
  int lowest = std::numeric_limits<int>::max();
  for (const auto points : {first, second}) {
    for (const Point& point : points) lowest = std::min({lowest, lowest_bit(point.x), lowest_bit(point.y)});
  }
  return lowest == std::numeric_limits<int>::max() ? 0 : lowest;
}

ExactCurve exact_curve(std::span<const Point> points, int exponent) {
  ExactCurve curve;
  curve.exponent = exponent;
  for (const Point& point : points) {
    if (curve.points.empty() || !(curve.points.back() == point)) curve.points.push_back(point);
  }
  while (curve.size() > 1 && curve.points.back() == curve.points.front()) curve.points.pop_back();
  for (const Point& point : curve.points) {
    curve.x.push_back(on_grid(point.x, exponent));
    curve.y.push_back(on_grid(point.y, exponent));
  }
  set_segments(curve);
  if (sgn(curve.twice_area) < 0) {
    curve.reversed = true;
    std::reverse(curve.points.begin() + 1, curve.points.end());
    std::reverse(curve.x.begin() + 1, curve.x.end());
    std::reverse(curve.y.begin() + 1, curve.y.end());
    set_segments(curve);
  }
  return curve;
}

int side(const ExactCurve& curve, std::size_t i, const ExactCurve& other, std::size_t j) {
  mpz_ptr value = scratch().get_mpz_t();
  mpz_mul(value, curve.dx[i].get_mpz_t(), other.y[j].get_mpz_t());
  mpz_submul(value, curve.dy[i].get_mpz_t(), other.x[j].get_mpz_t());
  return std::clamp(mpz_cmp(value, curve.offset[i].get_mpz_t()), -1, 1);
}

bool boxes_meet(const ExactCurve& first, std::size_t i, const ExactCurve& second, std::size_t j) {
  const Point& a = first.points[i];
  const Point& b = first.points[first.after(i)];
  const Point& c = second.points[j];
  const Point& d = second.points[second.after(j)];
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

bool within_box(const ExactCurve& curve, std::size_t i, const Point& point) {
  const Point& a = curve.points[i];
  const Point& b = curve.points[curve.after(i)];
  return std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= point.y &&
         point.y <= std::max(a.y, b.y);
}

int turn(const ExactCurve& first, std::size_t i, const ExactCurve& second, std::size_t j) {
  mpz_ptr value = scratch().get_mpz_t();
  mpz_mul(value, first.dx[i].get_mpz_t(), second.dy[j].get_mpz_t());
  mpz_submul(value, first.dy[i].get_mpz_t(), second.dx[j].get_mpz_t());
  return mpz_sgn(value);
}

bool contains(const ExactCurve& curve, const ExactCurve& other, std::size_t j) {
  // Count the segments that cross the ray to the right; half-open in y, so that vertices count once.
  const double level = other.points[j].y;
  bool inside = false;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool from_below = curve.points[i].y <= level;
    const bool to_below = curve.points[curve.after(i)].y <= level;
    if (from_below == to_below) continue;
    if ((side(curve, i, other, j) > 0) == from_below) inside = !inside;
  }
  return inside;
}

bool is_simple(std::span<const Point> points) {
  const ExactCurve curve = exact_curve(points, common_exponent(points, {}));
  const std::size_t count = curve.size();
  if (count < 3) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (folds_back(curve, i)) return false;
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;
      if (segments_meet(curve, i, j)) return false;
    }
  }
  return true;
}

}  // namespace lober::oracle
