#include "kernels/smooth_segment.hpp"

#include <algorithm>
#include <cmath>

namespace lober::detail {
namespace {

constexpr double cosine_of_corner = SmoothLimits::cosine_of_corner, cosine_of_stray = SmoothLimits::cosine_of_stray;
constexpr double outstanding = SmoothLimits::outstanding, uneven = SmoothLimits::uneven;

struct Chord {
  Point along;
  double length;
};

// The windows's chords and turns: chord k leads from vertex k to vertex k + 1, sine[k] is of the turn at vertex k.
struct Shape {
  explicit Shape(const std::array<Point, 8>& p) {
    for (std::size_t k = 0; k < 7; ++k) {
      const Point along{p[k + 1].x - p[k].x, p[k + 1].y - p[k].y};
      chord[k] = {along, std::sqrt(dot(along, along))};
    }
    for (std::size_t k = 1; k < 7; ++k) {
      const Chord &before = chord[k - 1], &after = chord[k];
      const double lengths = before.length * after.length;
      sharp[k] = !(dot(before.along, after.along) > cosine_of_corner * lengths);
      sine[k] = lengths > 0 ? cross(before.along, after.along) / lengths : 0;
    }
  }
  [[nodiscard]] bool corner(std::size_t k) const {
    return sharp[k] || std::fabs(sine[k]) > outstanding * std::max(std::fabs(sine[k - 1]), std::fabs(sine[k + 1]));
  }
  [[nodiscard]] bool usable(std::size_t k, double max_unevenness) const {
    const double own = chord[3].length, other = chord[k].length;
    return other <= max_unevenness * own && own <= max_unevenness * other &&
           dot(chord[k].along, chord[3].along) > cosine_of_stray * own * other;
  }
  // How often turns strictly between two vertices change sign.
  [[nodiscard]] int changes_of_sign(std::size_t first, std::size_t last) const {
    int changes = 0;
    double previous = 0;
    for (std::size_t k = first + 1; k < last; ++k) {
      if (sine[k] == 0) continue;
      changes += previous * sine[k] < 0;
      previous = sine[k] < 0 ? -1 : 1;
    }
    return changes;
  }

  std::array<Chord, 7> chord;
  std::array<double, 8> sine{};
  std::array<bool, 8> sharp{};
};

// Twice the area per |e|^2 of the chord-to-arc area of u (u - 1) g: -2 times the integral.
double chord_area_of(const std::array<double, 4>& g) {
  return 2 * (g[0] / 6 + g[1] / 12 + g[2] / 20 + g[3] / 30);
}

// Values of g that up to six vertices demand. Newton's form, so that one that comes later changes nothing before.
class Demands {
 public:
  void add(Point from, Point vertex, const Chord& chord) {
    const Point away{vertex.x - from.x, vertex.y - from.y};
    const double square = chord.length * chord.length;
    const double u = dot(away, chord.along) / square;
    double value = cross(chord.along, away) / square / (u * (u - 1));
    largest_ = std::max(largest_, std::fabs(value));
    for (std::size_t k = 0; k < count_; ++k) value = (value - divided_[k]) / (u - at_[k]);
    at_[count_] = u;
    divided_[count_++] = value;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double largest() const { return largest_; }
  // The change of chord_area_of by the fifth and the sixth.
  [[nodiscard]] double change_of_area() const {
    std::array<double, 6> w{1};  // vanishes at the first four
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t power = 4; power > 0; --power) w[power] = w[power - 1] - at_[k] * w[power];
      w[0] = -at_[k] * w[0];
    }
    double fifth = w[4] / 42, sixth = w[4] / 56;
    for (std::size_t power = 4; power-- > 0;) {
      fifth += w[power] / areas_of_powers[power];
      sixth += w[power] / areas_of_powers[power + 1];
    }
    return 2 * (divided_[4] * fifth + divided_[5] * (sixth - at_[4] * fifth));
  }
  // Coefficients of the polynomial through the first `count`.
  [[nodiscard]] std::array<double, 4> polynomial(std::size_t count) const {
    std::array<double, 4> g{};
    for (std::size_t k = count; k-- > 0;) {
      for (std::size_t power = 3; power > 0; --power) g[power] = g[power - 1] - at_[k] * g[power];
      g[0] = divided_[k] - at_[k] * g[0];
    }
    return g;
  }

 private:
  static constexpr std::array<double, 5> areas_of_powers{6, 12, 20, 30, 42};

  std::array<double, 6> at_{}, divided_{};
  double largest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

Point SmoothSegment::at(double u) const {
  const double y = u * (f[1] + u * (f[2] + u * (f[3] + u * (f[4] + u * f[5]))));
  return {u * chord.x - y * chord.y, u * chord.y + y * chord.x};
}

Point SmoothSegment::velocity(double u) const {
  const double slope = f[1] + u * (2 * f[2] + u * (3 * f[3] + u * (4 * f[4] + u * 5 * f[5])));
  return {chord.x - slope * chord.y, chord.y + slope * chord.x};
}

double SmoothSegment::chord_area(double u) const {
  // A term c u^k of f leaves c u^(k + 1) (1 - 2 / (k + 1)).
  const double sum = u * u * u * (f[2] / 3 + u * (f[3] / 2 + u * (f[4] * 0.6 + u * f[5] * (2.0 / 3))));
  return dot(chord, chord) * sum;
}

SmoothSegment fit_smooth_segment(const std::array<Point, 8>& p) {
  const Shape shape(p);
  SmoothSegment segment;
  const Chord& chord = shape.chord[3];
  segment.chord = chord.along;
  if (chord.length == 0) return segment;

  std::size_t first = 3, last = 4;
  if (!shape.corner(3) && shape.usable(2, uneven)) {
    first = !shape.corner(2) && shape.usable(1, 2 * uneven) ? 1 : 2;
  }
  if (!shape.corner(4) && shape.usable(4, uneven)) {
    last = !shape.corner(5) && shape.usable(5, 2 * uneven) ? 6 : 5;
  }
  Demands demands;
  for (std::size_t away = 1; away <= 2; ++away) {
    if (first + away <= 3) demands.add(p[3], p[3 - away], chord);
    if (last >= 4 + away) demands.add(p[3], p[4 + away], chord);
  }
  const std::size_t count = demands.count();
  const double square = chord.length * chord.length;
  const auto turn = [&](std::size_t k) { return shape.corner(k) ? 0 : std::fabs(shape.sine[k]); };
  if (count == 0) {  // what a curve along which all of the turns at its ends takes place would enclose; corners apart
    segment.error = square * (turn(3) + turn(4)) / 6;
    return segment;
  }
  const std::array<double, 4> g = demands.polynomial(count), less = demands.polynomial(count > 2 ? 2 : count - 1);
  const double largest = demands.largest(), area = chord_area_of(g), change = std::fabs(area - chord_area_of(less));
  // From one side the last vertex changes less than those beyond would; one vertex on either side of a symmetrical
  // curve changes nothing, and leaves open what is of the order of the squares of turns.
  double unknown = change;
  if (count < 4) {
    const double larger = std::max(turn(3), turn(4));
    unknown = 3 * std::max(change, larger * larger * std::fabs(area));
  }
  if (count == 4 && shape.usable(0, 4 * uneven) && shape.usable(6, 4 * uneven)) {
    demands.add(p[3], p[0], chord);
    demands.add(p[3], p[7], chord);
    const double next = std::max(3 * std::fabs(demands.change_of_area()), change * change / std::fabs(area));
    if (next < change) unknown = next;
  }
  segment.error = square * (unknown + 0x1p-50) +
                  chord.length * (SmoothLimits::rounding * std::max(std::fabs(p[3].x), std::fabs(p[3].y)));
  const double at_one = g[0] + g[1] + g[2] + g[3];
  const bool wavers = shape.changes_of_sign(first, last) > 1 || shape.changes_of_sign(0, 7) > 2;
  if (wavers || !(std::fabs(g[0]) < 1 && std::fabs(at_one) < 1)) {
    segment.kind = SmoothSegment::Kind::noisy;
    segment.error += square * largest / 3;
    return segment;
  }
  segment.kind = SmoothSegment::Kind::smooth;
  segment.f = {0, -g[0], g[0] - g[1], g[1] - g[2], g[2] - g[3], g[3]};
  return segment;
}

}  // namespace lober::detail
