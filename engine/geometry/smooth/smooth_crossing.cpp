#include "engine/geometry/smooth/smooth_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "engine/geometry/smooth/segment_shapes.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {
namespace {

using State = SmoothPair::State;

// Squares of scaled coordinates do not overflow.
double size_of(Point a) {
  return std::sqrt(dot(a, a));
}

class ContactMover {
 public:
  ContactMover(const SmoothCurve& c1, const SmoothCurve& c2, std::span<const PolygonContact> contacts)
      : c1_(c1),
        c2_(c2),
        contacts_(contacts),
        shapes1_(c1, contacts.size()),
        shapes2_(c2, contacts.size()),
        first_(contacts.size()),
        pairs_(contacts.size()) {}

  void move(bool straight_too, std::span<SmoothContact> results) {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      first_[k] = {shapes1_.ask_for(contacts_[k].segment1), shapes2_.ask_for(contacts_[k].segment2)};
      start(k);
    }
    shapes1_.fit();
    shapes2_.fit();
    Buffer<std::uint32_t> running;
    running.reserve(contacts_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const PolygonContact& contact = contacts_[k];
      SmoothContact& result = results[k];
      result.on1 = {contact.segment1, contact.t1};
      result.on2 = {contact.segment2, contact.t2};
      result.moved = false;
      result.straight = straight(pairs_[k]);
      if (contact.sense == PolygonContact::Sense::stays || (result.straight && !straight_too)) continue;
      pairs_[k].state = State::running;
      running.push_back(static_cast<std::uint32_t>(k));
    }
    Buffer<std::uint32_t> elsewhere;
    while (!running.empty()) {
      approach_crossings(pairs_.data(), running.data(), running.size(), shapes1_.data(), shapes2_.data());
      for (const std::uint32_t k : running) {
        if (pairs_[k].state == State::outside) enter_neighbours(k);
      }
      shapes1_.fit();
      shapes2_.fit();
      std::size_t left = 0;
      for (const std::uint32_t k : running) {
        SmoothPair& pair = pairs_[k];
        if (pair.state == State::running) {
          running[left++] = k;
          continue;
        }
        if (pair.state == State::tired) pair.state = close_enough(pair) ? State::met : State::stays;
        if (pair.state == State::stays) {
          if (pair.shape1 != first_[k][0] || pair.shape2 != first_[k][1]) start(k);
          pair.on1.u = contacts_[k].t1;
          pair.on2.u = contacts_[k].t2;
          continue;
        }
        SmoothContact& result = results[k];
        result.on1 = {shapes1_.segment(pair.shape1), pair.on1.u};
        result.on2 = {shapes2_.segment(pair.shape2), pair.on2.u};
        result.moved = true;
        const bool here = result.on1.segment == contacts_[k].segment1 && result.on2.segment == contacts_[k].segment2;
        if (!here) elsewhere.push_back(k);
      }
      running.resize(left);
    }
    Buffer<EndOfArcs> ends(contacts_.size());
    end_arcs(pairs_.data(), pairs_.size(), shapes1_.data(), shapes2_.data(), ends.data());
    for (std::size_t k = 0; k < contacts_.size(); ++k) results[k].ends = ends[k];
    for (const std::uint32_t k : elsewhere) {
      const SmoothPair& pair = pairs_[k];
      const Point meeting = point1(pair);
      const std::int64_t segment1 = contacts_[k].segment1, segment2 = contacts_[k].segment2;
      results[k].ends.on1 = loop(c1_, shapes1_, segment1, pair, pair.shape1, pair.on1.u, meeting, meeting);
      results[k].ends.on2 = loop(c2_, shapes2_, segment2, pair, pair.shape2, pair.on2.u, point2(pair), meeting);
    }
  }

 private:
  // Where the polygons meet.
  void start(std::size_t k) {
    const PolygonContact& contact = contacts_[k];
    const Point origin = c1_.vertex(contact.segment1), along = c1_.vertex(contact.segment1 + 1) - origin;
    SmoothPair& pair = pairs_[k];
    pair.shape1 = first_[k][0];
    pair.shape2 = first_[k][1];
    pair.on1 = {contact.t1, {0, 0}};
    pair.on2 = {contact.t2, c2_.vertex(contact.segment2) - origin};
    pair.polygons = {contact.t1 * along.x, contact.t1 * along.y};
    pair.steps_left = SmoothPair::max_steps;
    pair.rightward_to_left = contact.sense == PolygonContact::Sense::rightward_to_left;
    pair.small = false;
    pair.state = State::stays;
  }

  [[nodiscard]] bool straight(const SmoothPair& pair) const {
    return shapes1_[pair.shape1].kind != SmoothSegment::Kind::smooth &&
           shapes2_[pair.shape2].kind != SmoothSegment::Kind::smooth;
  }

  // Moves both points of a pair that is outside on to the segments that they have come to, unless that leads too far:
  // more than two segments on either side.
  void enter_neighbours(std::uint32_t k) {
    SmoothPair& pair = pairs_[k];
    const Point origin = c1_.vertex(contacts_[k].segment1);
    if (!enter(pair.on1, pair.shape1, c1_, shapes1_, contacts_[k].segment1, origin) ||
        !enter(pair.on2, pair.shape2, c2_, shapes2_, contacts_[k].segment2, origin)) {
      pair.state = State::stays;
    } else {
      pair.state = pair.small ? State::met : pair.steps_left == 0 ? State::tired : State::running;
    }
  }
  static bool enter(SmoothPair::Runner& runner, std::uint32_t& shape, const SmoothCurve& curve, SegmentShapes& shapes,
                    std::int64_t start, Point origin) {
    constexpr std::int64_t farthest = 2;
    if (!SmoothPair::leaves(runner.u)) return true;
    std::int64_t segment = shapes.segment(shape);
    const auto length_of = [&](std::int64_t at) { return size_of(curve.vertex(at + 1) - curve.vertex(at)); };
    while (SmoothPair::leaves(runner.u)) {
      const bool back = runner.u < 0;
      const double own = length_of(segment);
      segment += back ? -1 : 1;
      if (std::llabs(segment - start) > farthest) return false;
      const double next = length_of(segment);
      if (next == 0) return false;
      const double fraction = std::clamp((back ? runner.u : runner.u - 1) * own / next, -1.0, 1.0);
      runner.u = back ? 1 + fraction : fraction;
    }
    shape = shapes.ask_for(segment, shape);
    runner.vertex = curve.vertex(segment) - origin;
    return true;
  }

  [[nodiscard]] Point point1(const SmoothPair& pair) const {
    return pair.on1.vertex + shapes1_[pair.shape1].at(pair.on1.u);
  }
  [[nodiscard]] Point point2(const SmoothPair& pair) const {
    return pair.on2.vertex + shapes2_[pair.shape2].at(pair.on2.u);
  }
  // The rest of a shallow crossing may be rounding, which the distance of the curves shows.
  [[nodiscard]] bool close_enough(const SmoothPair& pair) const {
    const double longer = std::max(size_of(shapes1_[pair.shape1].chord), size_of(shapes2_[pair.shape2].chord));
    return size_of(point2(pair) - point1(pair)) <= SmoothPair::small_step * longer;
  }

  // Twice the area of this loop: from where the polygons meet on the segment `start`, along the polygon to the segment
  // that the shape belongs to, along the smooth curve to the point `at` on it, straight to `to` and back; with the
  // chord-to-arc areas of whole segments between.
  [[nodiscard]] double loop(const SmoothCurve& curve, const SegmentShapes& shapes, std::int64_t start,
                            const SmoothPair& pair, std::uint32_t shape, double u, Point at, Point to) const {
    const Point origin = c1_.vertex(contacts_[static_cast<std::size_t>(&pair - pairs_.data())].segment1);
    const std::int64_t last = shapes.segment(shape);
    double sum = shapes[shape].chord_area(u);
    Point previous{};  // relative to the start, so that the sides there have no term
    const auto go_to = [&](Point next) {
      next = next - pair.polygons;
      sum += cross(previous, next);
      previous = next;
    };
    const auto whole = [&](std::int64_t segment) {
      const std::optional<std::uint32_t> found = shapes.find(segment, shape);
      return (found ? shapes[*found] : curve.segment(segment)).chord_area(1);
    };
    for (std::int64_t k = start; k < last; ++k) {
      go_to(curve.vertex(k + 1) - origin);
      sum += whole(k);
    }
    if (last <= start) go_to(curve.vertex(start) - origin);
    for (std::int64_t k = start; k > last; --k) {
      go_to(curve.vertex(k - 1) - origin);
      sum -= whole(k - 1);
    }
    go_to(at);
    go_to(to);
    return sum;
  }

  const SmoothCurve &c1_, &c2_;
  std::span<const PolygonContact> contacts_;
  SegmentShapes shapes1_, shapes2_;
  Buffer<std::array<std::uint32_t, 2>> first_;  // shapes of the segments on which the polygons meet
  Buffer<SmoothPair> pairs_;                    // where each contact is
};

}  // namespace

void move_contacts(const SmoothCurve& c1, const SmoothCurve& c2, std::span<const PolygonContact> contacts,
                   bool straight_too, std::span<SmoothContact> moved) {
  ContactMover(c1, c2, contacts).move(straight_too, moved);
}

}  // namespace lober::detail
