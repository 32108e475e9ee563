#include "engine/densify/criteria.hpp"

#include <algorithm>
#include <cmath>

#include "engine/index/box_tree.hpp"

namespace lober {
namespace {

constexpr double many_parts = 0x1p31;  // beyond, no result could be stored

double distance(Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

bool counts_angles(const Criteria& criteria) {
  return criteria.angle < Criteria::off || criteria.distance_angle < Criteria::off;
}

// The next whole number, at least 1.
double whole(double parts) {
  if (!(parts > 1)) return 1;
  if (parts >= many_parts) return many_parts;
  const auto below = static_cast<std::uint32_t>(parts);
  return below < parts ? below + 1.0 : below;
}

}  // namespace

Criteria hobson_criteria(CurveView curve) {
  validate(curve, "the curve to densify");
  const Box box = BoxTree(curve).box();
  const double extent = std::max(box.width(), box.height());
  return {.longest = Criteria::off, .angle = 0.3, .distance_angle = 1e-3 * extent, .shortest = 1e-6 * extent};
}

void require_sensible(const Criteria& criteria) {
  if (!(criteria.longest > 0) || !(criteria.angle > 0) || !(criteria.distance_angle > 0)) {
    throw UsageError("densify: distance, angle and distance times angle have to be positive");
  }
  if (!(criteria.shortest >= 0) || criteria.shortest == Criteria::off) {
    throw UsageError("densify: the shortest length has to be zero or positive, and finite");
  }
  if (criteria.shortest == 0 && counts_angles(criteria)) {
    throw UsageError("densify: angle criteria need a shortest length, since a corner stays one at any length");
  }
}

double excess_of_angle(const Criteria& criteria, double angle, double mine, double other) {
  const double by_angle = 2 * mine >= other ? angle / criteria.angle : 0;
  return std::max(by_angle, std::sqrt(mine * angle / criteria.distance_angle));
}

double excess_at_vertex(const Criteria& criteria, Point a, Point b, Point c, double mine, double other) {
  if (!counts_angles(criteria)) return 0;
  const double bound = turning_angle_bound(a, b, c);
  if (bound <= criteria.angle && mine * bound <= criteria.distance_angle) return 0;
  return excess_of_angle(criteria, turning_angle(a, b, c), mine, other);
}

Judge::Judge(const Interpolant& interpolant, const Criteria& criteria, double extent)
    : interpolant_(interpolant),
      curve_(interpolant.curve()),
      criteria_(criteria),
      floor_(std::max(criteria.shortest, 0x1p-50 * extent)),
      angles_(counts_angles(criteria)) {}

Need Judge::grown(std::uint32_t parts, double growth, double chord) const {
  if (!(growth > 1)) return {parts, false};
  const double wanted = std::min(std::max(whole(parts * growth), parts + 1.0), many_parts);
  if (wanted * floor_ <= chord) return {static_cast<std::uint32_t>(wanted), false};
  const double most = std::clamp(std::floor(chord / floor_), 1.0, many_parts);
  return {std::max(parts, static_cast<std::uint32_t>(std::min(wanted, most))), true};
}

// With so many parts the criteria hold for all of them and at the vertices between them. One part is the chord,
// whatever the cubic.
double Judge::parts_by_bounds(const CubicPiece& piece, double chord) const {
  if (interpolant_.kind() == Interpolation::linear) return chord / criteria_.longest;
  const PieceBounds bounds = bounds_of(piece);
  const double speed = std::sqrt(bounds.speed2);
  const double by_length = chord <= criteria_.longest ? 0 : speed / criteria_.longest;
  if (!angles_) return by_length;
  if (!(bounds.advance > 0)) return Criteria::off;
  // asin(x) <= 1.05 x up to x = 1/2; the sine of an angle a <= 1/2 is at least 0.95 a. Larger angles are not bounded.
  const double bend = chord * std::sqrt(bounds.bend2) / bounds.advance;
  const double by_angle = bend / (0.95 * std::min(criteria_.angle, 0.5));
  return std::max({by_length, by_angle, std::sqrt(1.05 * speed * bend / criteria_.distance_angle)});
}

Need Judge::estimate(std::size_t k) const {
  const Point a = vertex(k), b = vertex(k + 1);
  const double chord = distance(a, b);
  double growth = parts_by_bounds(interpolant_.piece(k), chord);
  if (!(growth < Criteria::off)) growth = 0;  // nothing is known but the angles at the ends
  if (angles_) {
    // The parts of a chord keep the angles at its ends, those of a cubic share them. A bound that is near the angle
    // does.
    const auto at_vertex = [&](Point before, Point here, Point after, double other) {
      const double bound = turning_angle_bound(before, here, after);
      const double angle = bound < 0.5 ? bound : turning_angle(before, here, after);
      const double excess = excess_of_angle(criteria_, angle, chord, other);
      growth = std::max(growth, interpolant_.kind() == Interpolation::linear ? excess * excess : excess);
    };
    if (has_before(k)) {
      const Point before_a = vertex(k == 0 ? curve_.points.size() - 1 : k - 1);
      at_vertex(before_a, a, b, distance(before_a, a));
    }
    if (has_after(k)) {
      const Point after_b = vertex(k + 1 == curve_.points.size() ? 1 : k + 2);
      at_vertex(a, b, after_b, distance(b, after_b));
    }
  }
  return grown(1, growth, chord);
}

Point Judge::before(std::size_t segment, const Buffer<std::uint32_t>& parts) const {
  const std::size_t previous = segment == 0 ? curve_.segments() - 1 : segment - 1;
  const std::uint32_t count = parts[previous];
  return count == 1 ? vertex(previous) : interpolant_.piece(previous).at((count - 1) * (1.0 / count));
}

Point Judge::after(std::size_t segment, const Buffer<std::uint32_t>& parts) const {
  const std::size_t next = segment + 1 == curve_.segments() ? 0 : segment + 1;
  const std::uint32_t count = parts[next];
  return count == 1 ? vertex(next + 1) : interpolant_.piece(next).at(1.0 / count);
}

double Judge::growth_by_points(std::size_t segment, const Buffer<std::uint32_t>& parts) const {
  const std::uint32_t count = parts[segment];
  const CubicPiece piece = interpolant_.piece(segment);
  const double step = 1.0 / count;
  const Point end = vertex(segment + 1);
  const auto point = [&](std::uint32_t k) { return k == 0 ? piece.a : k == count ? end : piece.at(k * step); };
  double growth = 0;
  const Point second = point(1), last_but_one = point(count - 1);
  if (has_before(segment)) {
    const Point previous = before(segment, parts);
    const double length = distance(piece.a, second);
    growth =
        std::max(growth, excess_at_vertex(criteria_, previous, piece.a, second, length, distance(previous, piece.a)));
  }
  if (has_after(segment)) {
    const Point next = after(segment, parts);
    const double length = distance(last_but_one, end);
    growth = std::max(growth, excess_at_vertex(criteria_, last_but_one, end, next, length, distance(end, next)));
  }
  if (count >= parts_by_bounds(piece, distance(piece.a, end))) return growth;
  Point a = piece.a, b = second;
  double length = distance(a, b);
  growth = std::max(growth, length / criteria_.longest);
  for (std::uint32_t k = 2; k <= count; ++k) {
    const Point c = point(k);
    const double next_length = distance(b, c);
    growth = std::max(growth, next_length / criteria_.longest);
    growth = std::max(growth, excess_at_vertex(criteria_, a, b, c, std::max(length, next_length), 0));
    a = b;
    b = c;
    length = next_length;
  }
  return growth;
}

Need Judge::judge(std::size_t segment, const Buffer<std::uint32_t>& parts) const {
  const double chord = distance(vertex(segment), vertex(segment + 1));
  return grown(parts[segment], growth_by_points(segment, parts), chord);
}

}  // namespace lober
