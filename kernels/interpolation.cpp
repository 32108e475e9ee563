#include "kernels/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lober {
namespace {

Point minus(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}

}  // namespace

CubicPiece linear_piece(Point a, Point b) {
  return {a, minus(b, a), {}, {}};
}

double curvature(Point a, Point b, Point c) {
  const Point e = minus(b, a), f = minus(c, b), g = minus(c, a);
  const double denominator = std::sqrt(dot(e, e) * dot(f, f)) * std::sqrt(dot(g, g));
  constexpr double largest = std::numeric_limits<double>::max();
  return denominator > 0 && denominator <= largest ? 2 * cross(e, f) / denominator : 0;
}

CubicPiece dritschel_piece(Point a, Point b, double curvature_a, double curvature_b) {
  const Point chord = minus(b, a);
  const double e = std::sqrt(dot(chord, chord));
  // eta = p (1 - p) (mu - gamma p), because mu + beta + gamma = 0.
  const double mu = -e * (2 * curvature_a + curvature_b) / 6;
  const double gamma = e * (curvature_b - curvature_a) / 6;
  return {a, chord, {-mu * chord.y, mu * chord.x}, {gamma * chord.y, -gamma * chord.x}};
}

CubicPiece spline_piece(Point a, Point b, Point second_a, Point second_b) {
  // With M'' linear between M_a and M_b: x = chord - h^2 / 6 t (1 - t) ((2 M_a + M_b) + t (M_b - M_a)).
  const Point chord = minus(b, a);
  const double factor = -dot(chord, chord) / 6;
  return {a,
          chord,
          {factor * (2 * second_a.x + second_b.x), factor * (2 * second_a.y + second_b.y)},
          {factor * (second_b.x - second_a.x), factor * (second_b.y - second_a.y)}};
}

void subdivide(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out) {
  const CubicPiece local = piece;
  const double step = 1.0 / parts;
  for (std::uint32_t k = first; k < last; ++k) *out++ = local.at(k * step);
}

double longest_part_squared(const CubicPiece& piece, std::uint32_t parts) {
  const CubicPiece local = piece;
  const double step = 1.0 / parts;
  Point before = local.a;
  double longest = 0;
  for (std::uint32_t k = 1; k <= parts; ++k) {
    const Point here = k < parts ? local.at(k * step) : Point{local.a.x + local.chord.x, local.a.y + local.chord.y};
    const Point part = minus(here, before);
    longest = std::max(longest, dot(part, part));
    before = here;
  }
  return longest;
}

double turning_angle(Point a, Point b, Point c) {
  const Point e = minus(b, a), f = minus(c, b);
  return std::atan2(std::fabs(cross(e, f)), dot(e, f));
}

double turning_angle_bound(Point a, Point b, Point c) {
  const Point e = minus(b, a), f = minus(c, b);
  const double sine = std::fabs(cross(e, f)), cosine = dot(e, f);
  if (sine == 0 && cosine >= 0) return 0;
  return cosine > 0 ? sine / cosine : std::numeric_limits<double>::infinity();
}

}  // namespace lober
