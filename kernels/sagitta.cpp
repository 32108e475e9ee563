#include "kernels/sagitta.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lober::detail {
namespace {

// A vertex is a corner where the direction turns by more than this, or where the curvature is this many times that at
// the other end of a segment: boundaries of tangles have corners at pips that hardly turn, among points that turn far
// less.
constexpr double cosine_of_corner = 0.70710678118654757;
constexpr double corner_curvature = 8;

// Curvature at the vertex between two segments. NaN where one has no length: then nothing is compared with it.
double curvature(Point a, double a_length, Point b, double b_length) {
  return 2 * std::fabs((a.x * b.y - a.y * b.x) / (a_length * b_length)) / (a_length + b_length);
}

// Tangent at the vertex between two segments, per unit of a parameter in which segment `mine` has length 1.
Point tangent(Point mine, double my_length, Point other, double other_length, bool corner) {
  const double cosine = dot(mine, other);
  if (corner || other_length == 0 || cosine < cosine_of_corner * my_length * other_length) return mine;
  const double sum = my_length + other_length;
  const double of_other = my_length / sum * (my_length / other_length), of_mine = other_length / sum;
  return {of_other * other.x + of_mine * mine.x, of_other * other.y + of_mine * mine.y};
}

}  // namespace

double twice_chord_area(Point p0, Point p1, Point p2, Point p3) {
  const Point before = p1 - p0, chord = p2 - p1, after = p3 - p2;
  const double chord_length = std::sqrt(dot(chord, chord));
  if (chord_length == 0) return 0;
  const double before_length = std::sqrt(dot(before, before)), after_length = std::sqrt(dot(after, after));
  const double curvature1 = curvature(before, before_length, chord, chord_length);
  const double curvature2 = curvature(chord, chord_length, after, after_length);
  const Point m1 = tangent(chord, chord_length, before, before_length, curvature1 > corner_curvature * curvature2);
  const Point m2 = tangent(chord, chord_length, after, after_length, curvature2 > corner_curvature * curvature1);
  return (cross(m1, chord) + cross(chord, m2)) / 5 - cross(m1, m2) / 30;
}

namespace {

constexpr std::size_t at_once = 256;

// Step by step over arrays and without a branch, so that compilers make vectors of it. Each length, product and sum is
// the one of the functions above; only those that they compute twice are computed once.
void areas_of_few(const Point* points, std::size_t count, double* areas) {
  double chord_x[at_once + 2], chord_y[at_once + 2], chord_length[at_once + 2];
  for (std::size_t k = 0; k < count + 2; ++k) {
    chord_x[k] = points[k + 1].x - points[k].x;
    chord_y[k] = points[k + 1].y - points[k].y;
    chord_length[k] = std::sqrt(chord_x[k] * chord_x[k] + chord_y[k] * chord_y[k]);
  }
  double bend[at_once + 3];  // curvature at the vertex between chords k - 1 and k
  bend[0] = bend[count + 2] = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < count + 1; ++k) {
    const double ax = chord_x[k], ay = chord_y[k], a = chord_length[k];
    const double bx = chord_x[k + 1], by = chord_y[k + 1], b = chord_length[k + 1];
    bend[k + 1] = 2 * std::fabs((ax * by - ay * bx) / (a * b)) / (a + b);
  }
  // Tangents at the vertex between chords k and k + 1, per unit of the parameter of the first and of the second.
  double first_x[at_once + 1], first_y[at_once + 1], second_x[at_once + 1], second_y[at_once + 1];
  for (std::size_t k = 0; k < count + 1; ++k) {
    const double ax = chord_x[k], ay = chord_y[k], a = chord_length[k];
    const double bx = chord_x[k + 1], by = chord_y[k + 1], b = chord_length[k + 1];
    const double dot = ax * bx + ay * by, sum = a + b;
    const double a_share = a / sum, b_share = b / sum;
    const double b_in_first = a_share * (a / b), a_in_second = b_share * (b / a);
    const double x1 = b_in_first * bx + b_share * ax, y1 = b_in_first * by + b_share * ay;
    const double x2 = a_in_second * ax + a_share * bx, y2 = a_in_second * ay + a_share * by;
    const double here = bend[k + 1];
    const bool corner1 = (b == 0) | (dot < cosine_of_corner * a * b) | (here > corner_curvature * bend[k]);
    const bool corner2 = (a == 0) | (dot < cosine_of_corner * b * a) | (here > corner_curvature * bend[k + 2]);
    first_x[k] = corner1 ? ax : x1;
    first_y[k] = corner1 ? ay : y1;
    second_x[k] = corner2 ? bx : x2;
    second_y[k] = corner2 ? by : y2;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double x = chord_x[k + 1], y = chord_y[k + 1];
    const double x1 = second_x[k], y1 = second_y[k], x2 = first_x[k + 1], y2 = first_y[k + 1];
    const double area = ((x1 * y - y1 * x) + (x * y2 - y * x2)) / 5 - (x1 * y2 - y1 * x2) / 30;
    areas[k] = chord_length[k + 1] == 0 ? 0 : area;
  }
}

}  // namespace

void twice_chord_areas(const Point* points, std::size_t count, double* areas) {
  for (std::size_t k = 0; k < count; k += at_once) areas_of_few(points + k, std::min(at_once, count - k), areas + k);
}

}  // namespace lober::detail
