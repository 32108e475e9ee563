// More points where the polygons of a growing tangle need them.
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/base/quantities.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/tangles/along_lattice.hpp"
#include "engine/dynamics/transport/tangles/tangle_box.hpp"
#include "kernels/elementary.hpp"
#include "kernels/smooth_segment.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::detail {
// Puts points into segments and their neighbours that lie where distances are true. Whether there are more points now.
bool TangleGrowth::refine(Side& side, std::vector<std::uint32_t> segments, const Box& box) {
  constexpr int parts = 4;
  GrownManifold& grown = side.growth->grown();
  const std::size_t count = segments.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (segments[k] > 0) segments.push_back(segments[k] - 1);
    if (segments[k] + 2 < grown.points.size()) segments.push_back(segments[k] + 1);
  }
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  std::erase_if(segments, [&](std::uint32_t k) {
    const auto after = std::upper_bound(
        grown.diagnostics.begin(), grown.diagnostics.end(), k,
        [](std::uint32_t segment, const GrowthDiagnostic& diagnostic) { return segment < diagnostic.first; });
    const bool with_diagnostic = after != grown.diagnostics.begin() &&
                                 k < std::prev(after)->first + std::prev(after)->count &&
                                 std::prev(after)->cause != GrowthDiagnosticCause::left_box;
    const Box ends = Box::of(grown.points[k], grown.points[k + 1]);
    return with_diagnostic || !meet(ends, box) || !within(ends, true_size(followed()));
  });
  const std::size_t added = side.growth->refine(segments, parts).size();
  side.compressed += added;  // compressed points lie outside the box, none is new
  return added > 0;
}

// Two polygons cross at random where their segments turn by more than the angle between them. Refines them at pips
// where they do; whether there was anything to refine.
bool TangleGrowth::refine_flat_pips() {
  constexpr double trusted = 2;  // angle over turning
  std::vector<std::uint32_t> on_u, on_s;
  const auto turning = [](const Buffer<Point>& points, std::size_t k) {
    double most = 0;
    for (std::size_t i = std::max<std::size_t>(k, 1); i <= std::min(k + 1, points.size() - 2); ++i) {
      const Point a = points[i - 1], b = points[i], c = points[i + 1];
      const Point in{b.x - a.x, b.y - a.y}, out{c.x - b.x, c.y - b.y};
      most = std::max(most, std::fabs(elementary::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y)));
    }
    return most;
  };
  const Buffer<Point>&u = u_.growth->grown().points, &s = s_.growth->grown().points;
  for (const Pip& pip : found_.pips) {
    const std::size_t i = pip.u.segment, j = pip.s.segment;
    if (i + 1 >= u.size() || j + 1 >= s.size()) continue;
    const Point a{u[i + 1].x - u[i].x, u[i + 1].y - u[i].y}, b{s[j + 1].x - s[j].x, s[j + 1].y - s[j].y};
    // S runs the other way, or the same one: the angle between lines.
    const double angle = elementary::atan2(std::fabs(a.x * b.y - a.y * b.x), std::fabs(a.x * b.x + a.y * b.y));
    if (angle > trusted * (turning(u, i) + turning(s, j))) continue;
    on_u.push_back(static_cast<std::uint32_t>(i));
    on_s.push_back(static_cast<std::uint32_t>(j));
  }
  const bool more_u = refine(u_, std::move(on_u), followed()), more_s = refine(s_, std::move(on_s), followed());
  return more_u || more_s;
}

// How far from the saddle a manifold is at a time, as long as that is near.
double TangleGrowth::distance_at(const Side& side, double time) {
  return side.local.reach * elementary::power(side.local.image().factor, time);
}

// Images of q come as near to the saddle of one manifold as the other passes it: segments there have to be short enough
// to pass on the right side, and boundaries, which have a corner at that image and one at the saddle, need vertices
// between them that show how the manifold bends.
void TangleGrowth::refine_near(Side& side, Point saddle, double apart) {
  constexpr int max_rounds = 24;
  constexpr double around = 4, parts = 8;
  const double reach = around * apart;
  const Box box = square_about(saddle, reach);
  for (int round = 0; round < max_rounds; ++round) {
    const Buffer<Point>& points = side.growth->grown().points;
    std::vector<std::uint32_t> segments;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      if (meet(Box::of(points[k], points[k + 1]), box) && distance(points[k], points[k + 1]) > apart / parts) {
        segments.push_back(static_cast<std::uint32_t>(k));
      }
    }
    if (segments.empty() || !refine(side, std::move(segments), followed())) return;
  }
}

// Where a manifold folds more tightly than its polygon shows, the polygon has corners, beside which no smooth curve is
// fitted to it. Refines it there until it has none, or segments are so short that nothing matters.
void TangleGrowth::refine_folds(Side& side) {
  constexpr int max_rounds = 12;
  constexpr double matters = 1e-2;
  const Buffer<Point>& points = side.growth->grown().points;
  for (int round = 0; round < max_rounds && side.folds_seen != points.size(); ++round) {
    side.folds_seen = points.size();
    std::vector<std::uint32_t> segments;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const Point in = points[k] - points[k - 1], out = points[k + 1] - points[k];
      const double before = length(in), after = length(out);
      const bool corner = !(dot(in, out) > SmoothLimits::cosine_of_corner * before * after);
      if (!corner || !(before + after > matters * tolerance_)) continue;
      segments.push_back(static_cast<std::uint32_t>(k - 1));
      segments.push_back(static_cast<std::uint32_t>(k));
    }
    if (segments.empty() || !refine(side, std::move(segments), followed())) return;
  }
}

double TangleGrowth::segments_to_compare() const {
  if (options_.lattice == Point{}) return 0;
  const Buffer<Point>&u = u_.growth->grown().points, &s = s_.growth->grown().points;
  const auto translates = static_cast<double>(translates_in_reach(u, s, options_.lattice));
  return static_cast<double>(u.size() + s.size() - 2) * (1 + 2 * translates);
}

// Whether this number of segments is more work than is done unasked; with a budget the clock ends it.
bool TangleGrowth::compares_too_much(double segments) {
  // A segment that is compared takes as long as this number of evaluations of a map.
  constexpr double evaluations_a_segment = 4;
  if (options_.budget > 0 || evaluations_a_segment * segments <= options_.max_work) return false;
  limit_ = "the manifolds run round the cylinder so often that those of the next row, with all their translates " +
           format_rounded(segments) + " segments or more, are more work than is done unasked; a " +
           std::string(quantity::seconds) + " allows more";
  return true;
}

// Segments expected in one more growth, where two have been compared; cautiously, so that no affordable row is refused.
double TangleGrowth::segments_expected() const {
  constexpr double caution = 2;
  return compared_ * compared_ / compared_before_ / caution;
}

// Segments of a manifold that cross others of it or, where the plane repeats itself, of its translates.
std::vector<std::uint32_t> TangleGrowth::segments_that_cross(Side& side) const {
  constexpr std::size_t at_once = 20'000;
  const CurveView curve(side.growth->grown());
  const IndexedCurve index(curve);
  std::vector<std::uint32_t> segments;
  const SelfMeetings meetings = self_meetings(index, at_once);
  for (const SegmentPair& pair : meetings.pairs) {
    segments.push_back(pair.first);
    segments.push_back(pair.second);
  }
  if (segments.empty()) side.check = meetings.check;
  if (options_.lattice == Point{}) return segments;
  const Reach reach = reach_of(curve.points, options_.lattice);
  std::vector<Point> copy(curve.points.size());
  for (int k = 1; k <= reach.to - reach.from; ++k) {
    std::transform(curve.points.begin(), curve.points.end(), copy.begin(),
                   [&](Point point) { return moved(point, options_.lattice, k); });
    for (const CommonPoint& point : common_points(index, IndexedCurve(CurveView{copy, false}))) {
      segments.push_back(point.first.segment);
      segments.push_back(point.second.segment);
    }
  }
  return segments;
}

// Refines a manifold where its polygon crosses itself or a translate, and only there. A place where it still does, near
// by.
std::optional<Point> TangleGrowth::refine_until_simple(Side& side) {
  constexpr int max_rounds = 8;
  const Buffer<Point>& points = side.growth->grown().points;
  if (side.simple == points.size()) return std::nullopt;
  std::vector<std::uint32_t> segments;
  for (int round = 0; round <= max_rounds; ++round) {
    segments = segments_that_cross(side);
    // Also far outside, as long as distances are true: what crosses itself there has lobes in common with others that
    // are not.
    if (segments.empty()) {
      side.simple = points.size();
      return std::nullopt;
    }
    if (round == max_rounds || !refine(side, segments, true_size(followed()))) break;
  }
  for (const std::uint32_t k : segments) {
    if (meet(Box::of(points[k], points[k + 1]), followed())) return points[k];
  }
  return std::nullopt;
}

}  // namespace lober::detail
