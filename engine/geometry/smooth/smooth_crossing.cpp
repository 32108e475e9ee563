#include "engine/geometry/smooth/smooth_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lober::detail {
namespace {

// A point that moves along a smooth curve. Coordinates are relative to `origin`, a vertex near by.
class Runner {
 public:
  static constexpr std::int64_t farthest = 2;

  Runner(const SmoothCurve& curve, SmoothPosition position, Point origin)
      : curve_(curve), start_(position.segment), origin_(origin), u_(position.u) {
    enter(position.segment);
  }
  [[nodiscard]] Point at() const { return vertex_ + shape_.at(u_); }
  [[nodiscard]] Point velocity() const { return shape_.velocity(u_); }
  [[nodiscard]] SmoothPosition position() const { return {segment_, u_}; }
  [[nodiscard]] const SmoothSegment& shape() const { return shape_; }
  [[nodiscard]] Point vertex() const { return vertex_; }

  // False when that leads too far. A segment holds a little beyond its ends, so that a crossing at a vertex, where the
  // two segments differ by less than they are wrong, is not chased to and fro.
  [[nodiscard]] bool move(double step) {
    constexpr double slack = 1e-6;
    u_ += std::clamp(step, -1.0, 1.0);
    while (u_ < -slack || u_ > 1 + slack) {
      const bool back = u_ < 0;
      const double own = length(shape_.chord), over = back ? u_ : u_ - 1;
      enter(back ? segment_ - 1 : segment_ + 1);
      const double next = length(shape_.chord);
      if (next == 0 || std::llabs(segment_ - start_) > farthest) return false;
      const double fraction = std::clamp(over * own / next, -1.0, 1.0);
      u_ = back ? 1 + fraction : fraction;
    }
    return true;
  }

 private:
  void enter(std::int64_t segment) {
    segment_ = segment;
    shape_ = curve_.segment(segment);
    vertex_ = curve_.vertex(segment) - origin_;
  }

  const SmoothCurve& curve_;
  std::int64_t start_, segment_ = 0;
  Point origin_, vertex_;
  double u_;
  SmoothSegment shape_;
};

// Twice the area of the loop from `from`, on the polygon's segment `segment`, along the polygon to the segment where
// the runner is, along the smooth curve to the runner, straight to `to` and back; with the chord-to-arc areas of whole
// segments between.
double loop(const SmoothCurve& curve, Point origin, std::int64_t segment, Point from, const Runner& runner, Point to) {
  const SmoothPosition position = runner.position();
  double sum = runner.shape().chord_area(position.u);
  Point previous{};  // relative to `from`, so that the sides there have no term
  const auto go_to = [&](Point next) {
    next = next - from;
    sum += cross(previous, next);
    previous = next;
  };
  for (std::int64_t k = segment; k < position.segment; ++k) {
    go_to(curve.vertex(k + 1) - origin);
    sum += curve.segment(k).chord_area(1);
  }
  if (position.segment <= segment) go_to(curve.vertex(segment) - origin);
  for (std::int64_t k = segment; k > position.segment; --k) {
    go_to(curve.vertex(k - 1) - origin);
    sum -= curve.segment(k - 1).chord_area(1);
  }
  go_to(runner.at());
  go_to(to);
  return sum;
}

}  // namespace

std::optional<SmoothCrossing> find_smooth_crossing(const SmoothCurve& c1, const SmoothCurve& c2, const Contact& contact,
                                                   bool rightward_to_left) {
  const Point origin = c1.vertex(contact.segment1);
  Runner on1(c1, {contact.segment1, contact.t1.hi}, origin), on2(c2, {contact.segment2, contact.t2.hi}, origin);
  constexpr int most = 30;
  constexpr double arrived = 1e-13;
  for (int k = 0; k < most; ++k) {
    const Point along1 = on1.velocity(), along2 = on2.velocity(), apart = on2.at() - on1.at();
    const double sine = cross(along1, along2);
    if (!(rightward_to_left ? sine > 0 : sine < 0)) return std::nullopt;
    const double step1 = cross(apart, along2) / sine, step2 = cross(apart, along1) / sine;
    if (!on1.move(step1) || !on2.move(step2)) return std::nullopt;
    if (std::fabs(step1) < arrived && std::fabs(step2) < arrived) return SmoothCrossing{on1.position(), on2.position()};
  }
  // The rest of a shallow crossing may be rounding, which the distance of the curves shows.
  const double left = length(on2.at() - on1.at());
  if (left > arrived * std::max(length(on1.shape().chord), length(on2.shape().chord))) return std::nullopt;
  return SmoothCrossing{on1.position(), on2.position()};
}

EndOfArcs end_of_arcs(const SmoothCurve& c1, const SmoothCurve& c2, const Contact& contact,
                      const std::optional<SmoothCrossing>& crossing) {
  const Point origin = c1.vertex(contact.segment1);
  const SmoothPosition here1{contact.segment1, contact.t1.hi}, here2{contact.segment2, contact.t2.hi};
  const Runner on1(c1, crossing ? crossing->position1 : here1, origin),
      on2(c2, crossing ? crossing->position2 : here2, origin);
  const Point a = c1.vertex(here1.segment), b = c1.vertex(here1.segment + 1);
  const Point polygons{here1.u * (b.x - a.x), here1.u * (b.y - a.y)};
  const Point meeting = crossing ? on1.at() : polygons;
  EndOfArcs ends;
  ends.on1 = loop(c1, origin, here1.segment, polygons, on1, meeting);
  ends.on2 = loop(c2, origin, here2.segment, polygons, on2, meeting);
  const double apart = length(on2.at() - on1.at());
  ends.uncertainty = on1.shape().error + on2.shape().error +
                     2 * apart * std::max(length(on1.shape().chord), length(on2.shape().chord));
  return ends;
}

}  // namespace lober::detail
