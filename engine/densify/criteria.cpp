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

std::uint32_t as_parts(double parts) {
  return static_cast<std::uint32_t>(std::clamp(parts, 1.0, many_parts));
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
  if (criteria.shortest == 0 && (criteria.angle < Criteria::off || criteria.distance_angle < Criteria::off)) {
    throw UsageError("densify: angle criteria need a shortest length, since a corner stays one at any length");
  }
}

double excess_at_vertex(const Criteria& criteria, Point a, Point b, Point c, double mine, double other) {
  const double bound = turning_angle_bound(a, b, c);
  if (bound <= criteria.angle && mine * bound <= criteria.distance_angle) return 0;
  const double angle = turning_angle(a, b, c);
  const double by_angle = 2 * mine >= other ? angle / criteria.angle : 0;
  return std::max(by_angle, std::sqrt(mine * angle / criteria.distance_angle));
}

Judge::Judge(const Interpolant& interpolant, const Criteria& criteria, double extent)
    : interpolant_(interpolant),
      curve_(interpolant.curve()),
      criteria_(criteria),
      floor_(std::max(criteria.shortest, 0x1p-50 * extent)),
      angles_(criteria.angle < Criteria::off || criteria.distance_angle < Criteria::off) {}

Need Judge::grown(std::uint32_t parts, double growth, double chord) const {
  if (!(growth > 1)) return {parts, false};
  const double wanted = std::max(std::ceil(parts * growth), parts + 1.0);
  const double most = std::max(std::floor(chord / floor_), 1.0);
  return {std::max(parts, as_parts(std::min(wanted, most))), wanted > most};
}

Need Judge::estimate(std::size_t k) const {
  const Point a = vertex(k), b = vertex(k + 1);
  const double chord = distance(a, b);
  double growth = chord / criteria_.longest;
  if (angles_) {
    // The parts of a chord keep the angles at its ends, those of a cubic share them.
    const auto at_vertex = [&](double excess) {
      growth = std::max(growth, interpolant_.kind() == Interpolation::linear ? excess * excess : excess);
    };
    if (has_before(k)) {
      const Point before_a = vertex(k == 0 ? curve_.points.size() - 1 : k - 1);
      at_vertex(excess_at_vertex(criteria_, before_a, a, b, chord, distance(before_a, a)));
    }
    if (has_after(k)) {
      const Point after_b = vertex(k + 1 == curve_.points.size() ? 1 : k + 2);
      at_vertex(excess_at_vertex(criteria_, a, b, after_b, chord, distance(b, after_b)));
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
  const auto point = [&](std::uint32_t k) { return k == count ? end : piece.at(k * step); };
  Point a = piece.a, b = point(1);
  double length = distance(a, b);
  double growth = length / criteria_.longest;
  if (has_before(segment)) {
    const Point previous = before(segment, parts);
    growth = std::max(growth, excess_at_vertex(criteria_, previous, a, b, length, distance(previous, a)));
  }
  for (std::uint32_t k = 2; k <= count; ++k) {
    const Point c = point(k);
    const double next_length = distance(b, c);
    growth = std::max(growth, next_length / criteria_.longest);
    const double longer = std::max(length, next_length);
    growth = std::max(growth, excess_at_vertex(criteria_, a, b, c, longer, 0));
    a = b;
    b = c;
    length = next_length;
  }
  if (has_after(segment)) {
    const Point next = after(segment, parts);
    growth = std::max(growth, excess_at_vertex(criteria_, a, b, next, length, distance(b, next)));
  }
  return growth;
}

Need Judge::judge(std::size_t segment, const Buffer<std::uint32_t>& parts) const {
  const std::uint32_t count = parts[segment];
  double growth = 0;
  if (angles_) {
    growth = growth_by_points(segment, parts);
  } else if (criteria_.longest < Criteria::off) {
    growth = std::sqrt(longest_part_squared(interpolant_.piece(segment), count)) / criteria_.longest;
  }
  return grown(count, growth, distance(vertex(segment), vertex(segment + 1)));
}

}  // namespace lober
