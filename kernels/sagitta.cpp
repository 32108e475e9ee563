#include "kernels/sagitta.hpp"

#include <cmath>

namespace lober {
namespace {

double cross(Point u, Point v) {
  return u.x * v.y - u.y * v.x;
}
double length(Point u) {
  return std::sqrt(u.x * u.x + u.y * u.y);
}
Point minus(Point u, Point v) {
  return {u.x - v.x, u.y - v.y};
}

// Tangent at the vertex between two segments, per unit of a parameter in which segment `mine` has length 1.
Point tangent(Point mine, double my_length, Point other, double other_length) {
  constexpr double cosine_of_corner = 0.70710678118654757;
  const double dot = mine.x * other.x + mine.y * other.y;
  if (other_length == 0 || dot < cosine_of_corner * my_length * other_length) return mine;
  const double sum = my_length + other_length;
  const double of_other = my_length / sum * (my_length / other_length), of_mine = other_length / sum;
  return {of_other * other.x + of_mine * mine.x, of_other * other.y + of_mine * mine.y};
}

}  // namespace

double twice_sagitta_area(Point p0, Point p1, Point p2, Point p3) {
  const Point before = minus(p1, p0), chord = minus(p2, p1), after = minus(p3, p2);
  const double chord_length = length(chord);
  if (chord_length == 0) return 0;
  const Point m1 = tangent(chord, chord_length, before, length(before));
  const Point m2 = tangent(chord, chord_length, after, length(after));
  return (cross(m1, chord) + cross(chord, m2)) / 5 - cross(m1, m2) / 30;
}

}  // namespace lober
