#include "engine/dynamics/transport/cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/manifolds/iterate_each.hpp"
#include "lober/connecting_orbit.hpp"

namespace lober::detail {

Cylinder::Cylinder(Point period, double depth) : length_(std::hypot(period.x, period.y)), depth_(depth) {
  along_ = {period.x / length_, period.y / length_};
}

double Cylinder::height(Point period, Point plane) {
  return (period.x * plane.y - period.y * plane.x) / std::hypot(period.x, period.y);
}

Point Cylinder::wrap(Point plane) const {
  const double s = along_.x * plane.x + along_.y * plane.y, t = along_.x * plane.y - along_.y * plane.x;
  const double angle = -2 * std::numbers::pi * std::remainder(s, length_) / length_;
  const double radius = std::sqrt(length_ * (t + depth_) / std::numbers::pi);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Point Cylinder::unwrap(Point wrapped) const {
  const double turns = -std::atan2(wrapped.y, wrapped.x) / (2 * std::numbers::pi);
  const double s = length_ * (turns < 0 ? turns + 1 : turns);
  const double t = std::numbers::pi * (wrapped.x * wrapped.x + wrapped.y * wrapped.y) / length_ - depth_;
  return {along_.x * s - along_.y * t, along_.y * s + along_.x * t};
}

std::vector<Point> wrapped(const Cylinder& cylinder, const PlanarMap& map, const LocalManifold& local,
                           const GrownManifold& grown, double tolerance) {
  const std::size_t segments = grown.points.size() - 1;
  // How many parts a segment needs: the middle of a straight one bends off its chord by so much.
  constexpr double max_parts_a_side = 1 << 16;
  std::vector<std::uint32_t> parts(segments);
  for_each_block(segments, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Point a = grown.points[k], b = grown.points[k + 1];
      const Point from = cylinder.wrap(a), to = cylinder.wrap(b);
      const Point middle = cylinder.wrap({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
      double bend = distance(middle, {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)});
      // A segment that runs round more than once shows nothing by its middle.
      const double chord = distance(from, to), straight = distance(a, b);
      if (chord < 0.5 * straight && straight > tolerance) bend = std::max(bend, straight);
      parts[k] = static_cast<std::uint32_t>(std::clamp(std::ceil(std::sqrt(bend / tolerance)), 1.0, max_parts_a_side));
    }
  });
  // The points between vertices, all that are in a segment one after the other.
  std::vector<std::size_t> first(segments + 1);
  for (std::size_t k = 0; k < segments; ++k) first[k + 1] = first[k] + parts[k] - 1;
  std::vector<Point> between(first[segments]);
  std::vector<int> iterates(between.size());
  const auto share = [&](std::size_t k, std::uint32_t part) { return static_cast<double>(part) / parts[k]; };
  const int steps = local.image().steps;
  for_each_block(segments, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (std::uint32_t part = 1; part < parts[k]; ++part) {
        const ManifoldPosition position = position_on(grown, local, {static_cast<std::uint32_t>(k), share(k, part)});
        const std::size_t at = first[k] + part - 1;
        between[at] = local.at(position.parameter);
        iterates[at] = position.images * steps;
      }
    }
  });
  for_each_block(between.size(), 256, [&](std::size_t begin, std::size_t end) {
    iterate_each(map, std::span(between).subspan(begin, end - begin), std::span(iterates).subspan(begin, end - begin));
  });
  std::vector<Point> points(segments + 1 + between.size());
  for_each_block(segments, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Point a = grown.points[k], b = grown.points[k + 1];
      Point* const here = points.data() + k + first[k];
      here[0] = a;
      for (std::uint32_t part = 1; part < parts[k]; ++part) {
        const Point at = between[first[k] + part - 1];
        const Point chord{a.x + share(k, part) * (b.x - a.x), a.y + share(k, part) * (b.y - a.y)};
        // Far out, where manifolds are followed coarsely, segments stay what they are.
        const bool near = distance(at, chord) <= 0.25 * distance(a, b);
        here[part] = near ? at : chord;
      }
    }
  });
  points.back() = grown.points[segments];
  for_each_block(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) points[k] = cylinder.wrap(points[k]);
  });
  return points;
}

}  // namespace lober::detail
