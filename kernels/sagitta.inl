// Body of twice_chord_areas and add_arc_measures (kernels/all.inl).
#pragma once

#include "kernels/sagitta.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// A vertex is a corner where the direction turns by more than this, or where the curvature is this many times that at
// the other end of a segment: boundaries of tangles have corners at pips that hardly turn, among points that turn far
// less. So are those beside segments too short for their squares.
constexpr double cosine_of_corner = 0.70710678118654757;
constexpr double corner_curvature = 8;
constexpr double least_product = 0x1p-1010;

constexpr std::size_t at_once = 256;

struct Chords {
  double x[at_once + 2], y[at_once + 2], length[at_once + 2];
};

// Step by step over arrays and without a branch, so that compilers make vectors of it. Each length, product and sum is
// the one of twice_chord_area; only those that it computes twice are computed once.
inline void areas_of_few(const Point* points, std::size_t count, Chords& chords, double* areas) {
  for (std::size_t k = 0; k < count + 2; ++k) {
    const double x = points[k + 1].x - points[k].x, y = points[k + 1].y - points[k].y;
    chords.x[k] = x;
    chords.y[k] = y;
    chords.length[k] = __builtin_sqrt(x * x + y * y);
  }
  // The divisors of the curvature and of both tangents at the vertex between chords k and k + 1.
  double bend[at_once + 3], per_product[at_once + 1], per_sum[at_once + 1];
  bend[0] = bend[count + 2] = __builtin_nan("");
  for (std::size_t k = 0; k < count + 1; ++k) {
    const double a = chords.length[k], b = chords.length[k + 1], product = a * b, sum = a + b;
    per_product[k] = 1 / product;
    per_sum[k] = 1 / sum;
    bend[k + 1] =
        2 * __builtin_fabs(chords.x[k] * chords.y[k + 1] - chords.y[k] * chords.x[k + 1]) * per_product[k] * per_sum[k];
  }
  // Tangents at that vertex, per unit of the parameter of the first and of the second.
  double first_x[at_once + 1], first_y[at_once + 1], second_x[at_once + 1], second_y[at_once + 1];
  for (std::size_t k = 0; k < count + 1; ++k) {
    const double ax = chords.x[k], ay = chords.y[k], a = chords.length[k];
    const double bx = chords.x[k + 1], by = chords.y[k + 1], b = chords.length[k + 1];
    const double dot = ax * bx + ay * by, product = a * b;
    const double a_share = a * per_sum[k], b_share = b * per_sum[k];
    const double b_in_first = a_share * (a * a * per_product[k]), a_in_second = b_share * (b * b * per_product[k]);
    const double x1 = b_in_first * bx + b_share * ax, y1 = b_in_first * by + b_share * ay;
    const double x2 = a_in_second * ax + a_share * bx, y2 = a_in_second * ay + a_share * by;
    const double here = bend[k + 1];
    const bool turns = !(product > least_product) | (dot < cosine_of_corner * product);
    const bool corner1 = turns | (here > corner_curvature * bend[k]);
    const bool corner2 = turns | (here > corner_curvature * bend[k + 2]);
    first_x[k] = corner1 ? ax : x1;
    first_y[k] = corner1 ? ay : y1;
    second_x[k] = corner2 ? bx : x2;
    second_y[k] = corner2 ? by : y2;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double x = chords.x[k + 1], y = chords.y[k + 1];
    const double x1 = second_x[k], y1 = second_y[k], x2 = first_x[k + 1], y2 = first_y[k + 1];
    const double area = ((x1 * y - y1 * x) + (x * y2 - y * x2)) * 0.2 - (x1 * y2 - y1 * x2) * (1.0 / 30);
    areas[k] = chords.length[k + 1] == 0 ? 0 : area;
  }
}

inline void areas_of_all(const Point* points, std::size_t count, double* areas) {
  Chords chords;
  for (std::size_t k = 0; k < count; k += at_once) {
    areas_of_few(points + k, count - k < at_once ? count - k : at_once, chords, areas + k);
  }
}

inline double sum_of(Lanes lane_sums) {
  return (lane_sums[0] + lane_sums[1]) + (lane_sums[2] + lane_sums[3]);
}

inline void arc_sums(const Point* points, std::size_t count, Point origin, ArcMeasures& sums) {
  Chords chords;
  alignas(32) double areas[at_once];
  for (std::size_t begin = 0; begin < count; begin += at_once) {
    const std::size_t few = count - begin < at_once ? count - begin : at_once, whole = few / lanes * lanes;
    areas_of_few(points + begin, few, chords, areas);
    const Point* from = points + begin + 1;
    Lanes area = splat(0), x = area, y = area, length = area, between = area;
    for (std::size_t k = 0; k < whole; k += lanes) {
      const Lanes low = load(&from[k].x), high = load(&from[k + 2].x);
      const Lanes ax = __builtin_shufflevector(low, high, 0, 2, 4, 6) - splat(origin.x);
      const Lanes ay = __builtin_shufflevector(low, high, 1, 3, 5, 7) - splat(origin.y);
      const Lanes dx = load(&chords.x[k + 1]), dy = load(&chords.y[k + 1]), term = ax * dy - ay * dx;
      area += term;
      x += term * (ax + ax + dx);
      y += term * (ay + ay + dy);
      length += load(&chords.length[k + 1]);
      between += absolute(load(&areas[k]));
    }
    sums.twice_area += sum_of(area);
    sums.moment_x += sum_of(x);
    sums.moment_y += sum_of(y);
    sums.length += sum_of(length);
    sums.chord_area += sum_of(between);
    for (std::size_t k = whole; k < few; ++k) {
      const double ax = from[k].x - origin.x, ay = from[k].y - origin.y, dx = chords.x[k + 1], dy = chords.y[k + 1];
      const double term = ax * dy - ay * dx;
      sums.twice_area += term;
      sums.moment_x += term * (ax + ax + dx);
      sums.moment_y += term * (ay + ay + dy);
      sums.length += chords.length[k + 1];
      sums.chord_area += __builtin_fabs(areas[k]);
    }
  }
}

}  // namespace
}  // namespace lober::detail
