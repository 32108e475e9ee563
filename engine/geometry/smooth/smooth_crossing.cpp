#include "engine/geometry/smooth/smooth_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lober::detail {
namespace {

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

// A segment holds a little beyond its ends, so that a crossing at a vertex, where the two segments differ by less than
// they are wrong, is not chased to and fro.
bool Runner::move(double step) {
  constexpr double slack = 1e-6;
  constexpr std::int64_t farthest = 2;
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

std::optional<SmoothCrossing> SmoothContact::move_to_crossing(bool rightward_to_left) {
  Runner on1 = on1_, on2 = on2_;
  constexpr int most = 30;
  constexpr double small = 1e-13;
  bool arrived = false;
  for (int k = 0; k < most && !arrived; ++k) {
    const Point along1 = on1.velocity(), along2 = on2.velocity(), apart = on2.at() - on1.at();
    const double sine = cross(along1, along2);
    if (!(rightward_to_left ? sine > 0 : sine < 0)) return std::nullopt;
    const double step1 = cross(apart, along2) / sine, step2 = cross(apart, along1) / sine;
    if (!on1.move(step1) || !on2.move(step2)) return std::nullopt;
    arrived = std::fabs(step1) < small && std::fabs(step2) < small;
  }
  if (!arrived) {
    // The rest of a shallow crossing may be rounding, which the distance of the curves shows.
    const double left = length(on2.at() - on1.at());
    if (left > small * std::max(length(on1.shape().chord), length(on2.shape().chord))) return std::nullopt;
  }
  on1_ = on1;
  on2_ = on2;
  moved_ = true;
  return SmoothCrossing{on1_.position(), on2_.position()};
}

EndOfArcs SmoothContact::ends() const {
  const Point a = c1_.vertex(here1_.segment), b = c1_.vertex(here1_.segment + 1);
  const Point polygons{here1_.u * (b.x - a.x), here1_.u * (b.y - a.y)};
  const Point meeting = moved_ ? on1_.at() : polygons;
  EndOfArcs ends;
  ends.on1 = loop(c1_, origin_, here1_.segment, polygons, on1_, meeting);
  ends.on2 = loop(c2_, origin_, here2_.segment, polygons, on2_, meeting);
  const double apart = length(on2_.at() - on1_.at());
  ends.uncertainty = on1_.shape().error + on2_.shape().error +
                     2 * apart * std::max(length(on1_.shape().chord), length(on2_.shape().chord));
  return ends;
}

}  // namespace lober::detail
