#include "engine/geometry/smooth/smooth_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "engine/geometry/smooth/segment_shapes.hpp"
#include "kernels/smooth_approach.hpp"

namespace lober::detail {
namespace {

using Runner = SmoothApproach::Runner;

// Squares of scaled coordinates do not overflow.
double size_of(Point a) {
  return std::sqrt(dot(a, a));
}

// Twice the area of the loop from `from`, on the polygon's segment `segment`, along the polygon to the segment where
// the runner is, along the smooth curve to the runner, straight to `to` and back; with the chord-to-arc areas of whole
// segments between. The runner is at `at` on segment `last`.
double loop(const SmoothCurve& curve, Point origin, std::int64_t segment, Point from, std::int64_t last,
            const SmoothSegment& shape, double u, Point at, Point to) {
  double sum = shape.chord_area(u);
  Point previous{};  // relative to `from`, so that the sides there have no term
  const auto go_to = [&](Point next) {
    next = next - from;
    sum += cross(previous, next);
    previous = next;
  };
  for (std::int64_t k = segment; k < last; ++k) {
    go_to(curve.vertex(k + 1) - origin);
    sum += curve.segment(k).chord_area(1);
  }
  if (last <= segment) go_to(curve.vertex(segment) - origin);
  for (std::int64_t k = segment; k > last; --k) {
    go_to(curve.vertex(k - 1) - origin);
    sum -= curve.segment(k - 1).chord_area(1);
  }
  go_to(at);
  go_to(to);
  return sum;
}

class ContactMover {
 public:
  ContactMover(const SmoothCurve& c1, const SmoothCurve& c2, std::span<const PolygonContact> contacts)
      : c1_(c1), c2_(c2), contacts_(contacts), shapes1_(c1, contacts.size()), shapes2_(c2, contacts.size()) {}

  void move(bool straight_too, std::span<SmoothContact> results) {
    start();
    std::vector<SmoothApproach> running;
    std::vector<std::uint32_t> owners;
    running.reserve(contacts_.size());
    owners.reserve(contacts_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const PolygonContact& contact = contacts_[k];
      SmoothContact& result = results[k];
      result = {contact.on1, contact.on2, {}, false, straight(pairs_[k])};
      if (contact.sense == PolygonContact::Sense::stays || (result.straight && !straight_too)) continue;
      running.push_back(pairs_[k]);
      owners.push_back(static_cast<std::uint32_t>(k));
    }
    while (!running.empty()) {
      approach_crossings(running.data(), running.size(), shapes1_.data(), shapes2_.data());
      std::size_t left = 0;
      for (std::size_t j = 0; j < running.size(); ++j) {
        if (running[j].state != SmoothApproach::State::outside) continue;
        if (!enter_neighbours(running[j], contacts_[owners[j]])) running[j].state = SmoothApproach::State::away;
      }
      shapes1_.fit();
      shapes2_.fit();
      for (std::size_t j = 0; j < running.size(); ++j) {
        const SmoothApproach& pair = running[j];
        const std::uint32_t owner = owners[j];
        if (pair.state == SmoothApproach::State::running) {
          running[left] = pair;
          owners[left++] = owner;
        } else if (pair.state == SmoothApproach::State::met ||
                   (pair.state == SmoothApproach::State::tired && close_enough(pair))) {
          pairs_[owner] = pair;
          results[owner].on1 = {shapes1_.segment(pair.on1.shape), pair.on1.u};
          results[owner].on2 = {shapes2_.segment(pair.on2.shape), pair.on2.u};
          results[owner].moved = true;
        }
      }
      running.resize(left);
      owners.resize(left);
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) results[k].ends = ends(k, results[k]);
  }

 private:
  void start() {
    pairs_.resize(contacts_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto& [on1, on2, sense] = contacts_[k];
      SmoothApproach& pair = pairs_[k];
      pair.on1 = {shapes1_.ask_for(on1.segment), {}, on1.u};
      pair.on2 = {shapes2_.ask_for(on2.segment), c2_.vertex(on2.segment) - c1_.vertex(on1.segment), on2.u};
      pair.steps_left = SmoothApproach::max_steps;
      pair.rightward_to_left = sense == PolygonContact::Sense::rightward_to_left;
      pair.small = false;
      pair.state = SmoothApproach::State::running;
    }
    shapes1_.fit();
    shapes2_.fit();
  }

  [[nodiscard]] bool straight(const SmoothApproach& pair) const {
    return shapes1_[pair.on1.shape].kind != SmoothSegment::Kind::smooth &&
           shapes2_[pair.on2.shape].kind != SmoothSegment::Kind::smooth;
  }

  // Moves both points of a pair that is outside on to the segments that they have come to. False when that leads too
  // far: more than two segments on either side.
  bool enter_neighbours(SmoothApproach& pair, const PolygonContact& contact) {
    const Point origin = c1_.vertex(contact.on1.segment);
    if (!enter(pair.on1, c1_, shapes1_, contact.on1.segment, origin) ||
        !enter(pair.on2, c2_, shapes2_, contact.on2.segment, origin)) {
      return false;
    }
    pair.state = pair.small             ? SmoothApproach::State::met
                 : pair.steps_left == 0 ? SmoothApproach::State::tired
                                        : SmoothApproach::State::running;
    return true;
  }
  static bool enter(Runner& runner, const SmoothCurve& curve, SegmentShapes& shapes, std::int64_t start, Point origin) {
    constexpr std::int64_t farthest = 2;
    if (!SmoothApproach::leaves(runner.u)) return true;
    std::int64_t segment = shapes.segment(runner.shape);
    while (SmoothApproach::leaves(runner.u)) {
      const bool back = runner.u < 0;
      const double own = size_of(curve.vertex(segment + 1) - curve.vertex(segment));
      segment += back ? -1 : 1;
      const double next = size_of(curve.vertex(segment + 1) - curve.vertex(segment));
      if (next == 0 || std::llabs(segment - start) > farthest) return false;
      const double fraction = std::clamp((back ? runner.u : runner.u - 1) * own / next, -1.0, 1.0);
      runner.u = back ? 1 + fraction : fraction;
    }
    runner.shape = shapes.ask_for(segment, runner.shape);
    runner.vertex = curve.vertex(segment) - origin;
    return true;
  }

  [[nodiscard]] Point at1(const SmoothApproach& pair) const {
    return pair.on1.vertex + shapes1_[pair.on1.shape].at(pair.on1.u);
  }
  [[nodiscard]] Point at2(const SmoothApproach& pair) const {
    return pair.on2.vertex + shapes2_[pair.on2.shape].at(pair.on2.u);
  }
  [[nodiscard]] double longer_chord(const SmoothApproach& pair) const {
    return std::max(size_of(shapes1_[pair.on1.shape].chord), size_of(shapes2_[pair.on2.shape].chord));
  }
  // The rest of a shallow crossing may be rounding, which the distance of the curves shows.
  [[nodiscard]] bool close_enough(const SmoothApproach& pair) const {
    return size_of(at2(pair) - at1(pair)) <= SmoothApproach::small_step * longer_chord(pair);
  }

  [[nodiscard]] EndOfArcs ends(std::size_t k, const SmoothContact& result) const {
    const SmoothApproach& pair = pairs_[k];
    const PolygonContact& contact = contacts_[k];
    const Point origin = c1_.vertex(contact.on1.segment), along = c1_.vertex(contact.on1.segment + 1) - origin;
    const Point polygons{contact.on1.u * along.x, contact.on1.u * along.y};
    const Point first = at1(pair), second = at2(pair), meeting = result.moved ? first : polygons;
    const SmoothSegment &shape1 = shapes1_[pair.on1.shape], &shape2 = shapes2_[pair.on2.shape];
    EndOfArcs ends;
    ends.on1 = loop(c1_, origin, contact.on1.segment, polygons, result.on1.segment, shape1, pair.on1.u, first, meeting);
    ends.on2 =
        loop(c2_, origin, contact.on2.segment, polygons, result.on2.segment, shape2, pair.on2.u, second, meeting);
    ends.uncertainty = shape1.error + shape2.error + 2 * size_of(second - first) * longer_chord(pair);
    return ends;
  }

  const SmoothCurve &c1_, &c2_;
  std::span<const PolygonContact> contacts_;
  SegmentShapes shapes1_, shapes2_;
  std::vector<SmoothApproach> pairs_;  // where each contact is
};

}  // namespace

void move_contacts(const SmoothCurve& c1, const SmoothCurve& c2, std::span<const PolygonContact> contacts,
                   bool straight_too, std::span<SmoothContact> moved) {
  ContactMover(c1, c2, contacts).move(straight_too, moved);
}

}  // namespace lober::detail
