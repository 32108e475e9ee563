#include "kernels/interpolation.hpp"

#include <cmath>
#include <limits>

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/interpolation.inl"

namespace lober::detail {
double curvature(Point a, Point b, Point c) {
  const Point e = b - a, f = c - b, g = c - a;
  const double denominator = std::sqrt(dot(e, e) * dot(f, f)) * std::sqrt(dot(g, g));
  constexpr double largest = std::numeric_limits<double>::max();
  return denominator > 0 && denominator <= largest ? 2 * cross(e, f) / denominator : 0;
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
  const Point e = b - a, f = c - b;
  return std::atan2(std::fabs(cross(e, f)), dot(e, f));
}

double turning_angle_bound(Point a, Point b, Point c) {
  const Point e = b - a, f = c - b;
  const double sine = std::fabs(cross(e, f)), cosine = dot(e, f);
  if (sine == 0 && cosine >= 0) return 0;
  return cosine > 0 ? sine / cosine : std::numeric_limits<double>::infinity();
}

}  // namespace lober::detail
