#include "engine/geometry/densify/criteria.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/index/box_tree.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double many_parts = 0x1p31;  // beyond, no result could be stored

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
  return {.max_length = Criteria::off, .angle = 0.3, .distance_angle = 1e-3 * extent, .min_length = 1e-6 * extent};
}

void detail::require_sensible(const Criteria& criteria) {
  if (!(criteria.max_length > 0) || !(criteria.angle > 0) || !(criteria.distance_angle > 0)) {
    throw UsageError("densify: distance, angle and distance times angle have to be positive");
  }
  if (!(criteria.min_length >= 0) || criteria.min_length == Criteria::off) {
    throw UsageError("densify: the minimum length has to be zero or positive, and finite");
  }
  if (criteria.min_length == 0 && counts_angles(criteria)) {
    throw UsageError("densify: angle criteria need a minimum length, because a corner stays a corner at any length");
  }
}

bool detail::angle_surely_holds(const Criteria& criteria, Point a, Point b, Point c, double mine) {
  if (!counts_angles(criteria)) return true;
  const double bound = turning_angle_bound(a, b, c);
  return bound <= criteria.angle && mine * bound <= criteria.distance_angle;
}

VertexRequirement detail::requirement_at_vertex(const Criteria& criteria, double angle, double corner, double mine,
                                                double other) {
  VertexRequirement requirement;
  corner = std::min(corner, angle);
  if (angle > criteria.angle && 2 * mine >= other) {
    if (corner >= criteria.angle) {
      requirement.corner = true;
    } else {
      requirement.growth = (angle - corner) / (criteria.angle - corner);
    }
  }
  // Parts g times as short leave d alpha = mine / g (corner + (angle - corner) / g).
  const double linear = mine * corner / criteria.distance_angle;
  const double square = mine * (angle - corner) / criteria.distance_angle;
  requirement.growth = std::max(requirement.growth, (linear + std::sqrt(linear * linear + 4 * square)) / 2);
  return requirement;
}

Judge::Judge(const Interpolant& interpolant, const Criteria& criteria, double extent)
    : interpolant_(interpolant),
      curve_(interpolant.curve()),
      criteria_(criteria),
      floor_(std::max(criteria.min_length, 0x1p-50 * extent)),
      angles_(counts_angles(criteria)) {}

Requirement Judge::grown(std::uint32_t parts, VertexRequirement requirement, double chord) const {
  if (!(requirement.growth > 1)) return {parts, false, requirement.corner};
  const double wanted = std::min(std::max(whole(parts * requirement.growth), parts + 1.0), many_parts);
  if (wanted * floor_ <= chord) return {static_cast<std::uint32_t>(wanted), false, requirement.corner};
  const double most = std::clamp(std::floor(chord / floor_), 1.0, many_parts);
  return {std::max(parts, static_cast<std::uint32_t>(std::min(wanted, most))), true, requirement.corner};
}

// The number of parts with which the criteria hold for all of them and at the vertices between them. One part is the
// chord, whatever the cubic.
double Judge::parts_by_bounds(const CubicPiece& piece, double chord) const {
  if (interpolant_.kind() == Interpolation::linear) return chord / criteria_.max_length;
  const PieceBounds bounds = bounds_of(piece);
  const double speed = std::sqrt(bounds.speed2);
  const double by_length = chord <= criteria_.max_length ? 0 : speed / criteria_.max_length;
  if (!angles_) return by_length;
  if (!(bounds.advance > 0)) return Criteria::off;
  // asin(x) <= 1.05 x up to x = 1/2; the sine of an angle a <= 1/2 is at least 0.95 a. Larger angles are not bounded.
  const double bend = chord * std::sqrt(bounds.bend2) / bounds.advance;
  const double by_angle = bend / (0.95 * std::min(criteria_.angle, 0.5));
  return std::max({by_length, by_angle, std::sqrt(1.05 * speed * bend / criteria_.distance_angle)});
}

Requirement Judge::estimate(std::size_t k) const {
  const Point a = vertex(k), b = vertex(k + 1);
  const double chord = distance(a, b);
  VertexRequirement requirement{parts_by_bounds(interpolant_.piece(k), chord), false};
  const auto enough =
      static_cast<std::uint32_t>(requirement.growth < many_parts ? whole(requirement.growth) : many_parts);
  if (!(requirement.growth < Criteria::off)) requirement.growth = 0;  // nothing is known but the angles at the ends
  if (angles_) {
    // The parts of a chord keep the angles at its ends, those of a cubic share them. A bound that is near the angle
    // does.
    const auto at_vertex = [&](Point before, Point here, Point after, double other) {
      const double bound = turning_angle_bound(before, here, after);
      const double angle = bound < 0.5 ? bound : turning_angle(before, here, after);
      const double corner = interpolant_.kind() == Interpolation::linear ? angle : 0;
      requirement += requirement_at_vertex(criteria_, angle, corner, chord, other);
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
  Requirement result = grown(1, requirement, chord);
  result.enough = enough;
  return result;
}

// The angle between the tangents with which the pieces before and after a vertex meet there.
double Judge::corner_at(std::size_t vertex) const {
  const std::size_t after = vertex == curve_.segments() ? 0 : vertex;
  const CubicPiece in = interpolant_.piece(after == 0 ? curve_.segments() - 1 : after - 1);
  const CubicPiece out = interpolant_.piece(after);
  const Point arriving{in.chord.x - in.u.x - in.v.x, in.chord.y - in.u.y - in.v.y};
  const Point both{arriving.x + out.chord.x + out.u.x, arriving.y + out.chord.y + out.u.y};
  return turning_angle({0, 0}, arriving, both);
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

VertexRequirement Judge::requirement_by_points(std::size_t segment, const Buffer<std::uint32_t>& parts,
                                               std::uint32_t enough) const {
  const std::uint32_t count = parts[segment];
  const CubicPiece piece = interpolant_.piece(segment);
  const double step = 1.0 / count;
  const Point end = vertex(segment + 1);
  const auto point = [&](std::uint32_t k) { return k == 0 ? piece.a : k == count ? end : piece.at(k * step); };
  VertexRequirement requirement;
  const auto at_end = [&](std::size_t number, Point a, Point b, Point c, double mine, double other) {
    if (angle_surely_holds(criteria_, a, b, c, mine)) return;
    requirement += requirement_at_vertex(criteria_, turning_angle(a, b, c), corner_at(number), mine, other);
  };
  const Point second = point(1), last_but_one = point(count - 1);
  if (has_before(segment)) {
    const Point previous = before(segment, parts);
    at_end(segment, previous, piece.a, second, distance(piece.a, second), distance(previous, piece.a));
  }
  if (has_after(segment)) {
    const Point next = after(segment, parts);
    at_end(segment + 1, last_but_one, end, next, distance(last_but_one, end), distance(end, next));
  }
  if (count >= enough) return requirement;
  Point a = piece.a, b = second;
  double length = distance(a, b);
  requirement.growth = std::max(requirement.growth, length / criteria_.max_length);
  for (std::uint32_t k = 2; k <= count; ++k) {
    const Point c = point(k);
    const double next_length = distance(b, c), longer = std::max(length, next_length);
    requirement.growth = std::max(requirement.growth, next_length / criteria_.max_length);
    if (!angle_surely_holds(criteria_, a, b, c, longer)) {
      requirement += requirement_at_vertex(criteria_, turning_angle(a, b, c), 0, longer, 0);
    }
    a = b;
    b = c;
    length = next_length;
  }
  return requirement;
}

Requirement Judge::judge(std::size_t segment, const Buffer<std::uint32_t>& parts, std::uint32_t enough) const {
  const double chord = distance(vertex(segment), vertex(segment + 1));
  return grown(parts[segment], requirement_by_points(segment, parts, enough), chord);
}

}  // namespace lober
