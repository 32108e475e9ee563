#include "kernels/interpolation.hpp"

#include <cmath>
#include <limits>

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/interpolation.inl"

namespace lober {
double curvature(Point a, Point b, Point c) {
  const Point e = detail::minus(b, a), f = detail::minus(c, b), g = detail::minus(c, a);
  const double denominator = std::sqrt(detail::dot(e, e) * detail::dot(f, f)) * std::sqrt(detail::dot(g, g));
  constexpr double largest = std::numeric_limits<double>::max();
  return denominator > 0 && denominator <= largest ? 2 * detail::cross(e, f) / denominator : 0;
}

void subdivide_avx2(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out);

void subdivide(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out) {
  if (has_avx2()) {
    subdivide_avx2(piece, parts, first, last, out);
  } else {
    subdivide_with(piece, parts, first, last, out);
  }
}

double turning_angle(Point a, Point b, Point c) {
  const Point e = detail::minus(b, a), f = detail::minus(c, b);
  return std::atan2(std::fabs(detail::cross(e, f)), detail::dot(e, f));
}

double turning_angle_bound(Point a, Point b, Point c) {
  const Point e = detail::minus(b, a), f = detail::minus(c, b);
  const double sine = std::fabs(detail::cross(e, f)), cosine = detail::dot(e, f);
  if (sine == 0 && cosine >= 0) return 0;
  return cosine > 0 ? sine / cosine : std::numeric_limits<double>::infinity();
}

}  // namespace lober
