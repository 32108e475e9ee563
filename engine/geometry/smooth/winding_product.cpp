// The integral of the product of two winding numbers, of smooth curves.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/curve/cut_outside.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/smooth/smooth_curve.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober {
using namespace detail;
namespace {

// One closed curve along another one.
class AlongAnother {
 public:
  AlongAnother(const IndexedCurve& along, const IndexedCurve& other, int exponent)
      : along_(along.view().points),
        other_(other.view()),
        smooth_(along.view()),
        smooth_other_(other.view()),
        index_(other),
        common_(common_points(along, other)),
        scale_(std::ldexp(1, -2 * exponent)) {
    find_windings();
  }

  // The area that the arcs enclose beyond the segments, each weighted with the winding number of the other curve there.
  [[nodiscard]] CommonArea chord_areas() const {
    constexpr std::size_t segments_a_block = 2048;
    const std::size_t size = along_.size();
    std::vector<CommonArea> sums((size + segments_a_block - 1) / segments_a_block);
    for_each_block(size, segments_a_block, [&](std::size_t begin, std::size_t end) {
      CommonArea& sum = sums[begin / segments_a_block];
      auto next = std::lower_bound(common_.begin(), common_.end(), begin,
                                   [](const CommonPoint& point, std::size_t k) { return point.first.segment < k; });
      for (std::size_t k = begin; k < end; ++k) {
        const auto first = next;
        while (next != common_.end() && next->first.segment == k) ++next;
        const double from = numbers_[k], to = numbers_[k + 1 == size ? 0 : k + 1];
        if (from == 0 && to == 0 && first == next) continue;
        const SmoothSegment segment = smooth_.segment(static_cast<std::int64_t>(k));
        if (!add_parts(segment, k, first, next, sum)) {
          // Each common point may count one winding more or less for most of the segment.
          const double jumps = std::max(std::fabs(from - to), static_cast<double>(next - first));
          sum.area += (from + to) / 2 * segment.chord_area(1);
          sum.error += jumps / 2 * std::fabs(segment.chord_area(1)) + (std::fabs(from) + jumps) * segment.error;
        }
      }
    });
    CommonArea twice;
    for (const CommonArea& sum : sums) {
      twice.area += sum.area;
      twice.error += sum.error;
    }
    return {scale_ * twice.area / 2, scale_ * twice.error / 2};
  }

 private:
  using Points = std::vector<CommonPoint>::const_iterator;

  // Finds the winding numbers of the other curve about each vertex of this one: on it, the mean of both sides. One
  // query is made between two points that both have in common. Where the curves share an arc, the vertex after one on
  // the other curve is likely to lie on it too, which is seen from there at once.
  void find_windings() {
    std::vector<bool> ask(along_.size());
    for (const CommonPoint& point : common_) {
      const std::size_t segment = point.first.segment;
      if (point.vertex1) ask[segment] = true;
      ask[segment + 1 == along_.size() ? 0 : segment + 1] = true;
    }
    numbers_.resize(along_.size());
    for_each_block(along_.size(), 1024, [&](std::size_t begin, std::size_t end) {
      bool again = true, on = false;
      for (std::size_t k = begin; k < end; ++k) {
        if (!again && !ask[k]) {
          numbers_[k] = numbers_[k - 1];
          continue;
        }
        const Point at = along_[k];
        if (!on) {
          const Winding found = winding(index_, at);
          numbers_[k] = found.number;
          again = on = found.on;
          if (!on) continue;
        }
        // The principal value, pi times a whole number but at corners; off the curve 2 pi times one.
        const InteriorValue seen = interior_function(index_, at);
        const double turns = seen.j / std::numbers::pi;
        numbers_[k] = seen.on ? std::round(turns) / 2 : std::round(turns / 2);
        again = on = seen.on;
      }
    });
  }

  // Arc by arc between the points where the other curve crosses a segment, each with its winding number. False where
  // these points are not all crossings of two segments inside of both.
  bool add_parts(const SmoothSegment& segment, std::size_t k, Points first, Points last, CommonArea& sum) const {
    const double to = numbers_[k + 1 == along_.size() ? 0 : k + 1];
    double number = numbers_[k], begin = 0;
    CommonArea parts;
    // A part has no more of the error of a whole arc than a parabola over the segment has there.
    const auto add_part = [&](double end) {
      parts.area += number * between(segment, begin, end);
      parts.error += std::fabs(number) * std::min(1.5 * (end - begin), 1.0) * segment.error;
      begin = end;
    };
    for (Points point = first; point != last; ++point) {
      if (point->vertex1 || point->vertex2) return false;
      const Segment of_other = other_.segment(point->second.segment);
      const Point across{of_other.b.x - of_other.a.x, of_other.b.y - of_other.a.y};
      add_part(point->first.t);
      parts.error += hidden_at(segment, *point);
      // To the left of a curve its winding number is one more than to the right.
      number += across.x * segment.chord.y - across.y * segment.chord.x > 0 ? 1 : -1;
    }
    if (number != to) return false;
    add_part(1);
    sum.area += parts.area;
    sum.error += parts.error;
    return true;
  }

  // Twice the area between a part of an arc and its segment, positive to the right of it.
  [[nodiscard]] static double between(const SmoothSegment& segment, double from, double to) {
    const auto integral = [&](double u) {
      double sum = 0;
      for (std::size_t k = segment.f.size(); k-- > 0;) sum = (sum + segment.f[k] / static_cast<double>(k + 1)) * u;
      return sum;
    };
    const double square = segment.chord.x * segment.chord.x + segment.chord.y * segment.chord.y;
    return -2 * square * (integral(to) - integral(from));
  }

  // Twice the area that may hide where two arcs cross elsewhere than their segments: these lie at distances d and e
  // from them, so that it is (d + e)^2 / sin(angle).
  [[nodiscard]] double hidden_at(const SmoothSegment& segment, const CommonPoint& point) const {
    const SmoothSegment other = smooth_other_.segment(point.second.segment);
    const auto off = [](const SmoothSegment& arc, double u) {
      double f = 0;
      for (std::size_t k = arc.f.size(); k-- > 0;) f = f * u + arc.f[k];
      return std::fabs(f) * length(arc.chord);
    };
    const double distance = off(segment, point.first.t) + off(other, point.second.t);
    const double longest = std::max(length(segment.chord), length(other.chord));
    const double cross = std::fabs(segment.chord.x * other.chord.y - segment.chord.y * other.chord.x);
    const double sine = cross / (length(segment.chord) * length(other.chord));
    return distance * std::min(distance / std::max(sine, 1e-300), longest);
  }

  std::span<const Point> along_;
  CurveView other_;
  SmoothCurve smooth_, smooth_other_;
  const IndexedCurve& index_;        // index of the other curve
  std::vector<CommonPoint> common_;  // in order along this one
  double scale_;
  std::vector<double> numbers_;  // by vertex
};

// Vertices on either side of a segment that its arc is fitted to, kernels/smooth_segment.hpp.
constexpr std::size_t fitted_beside = 3;

// Cuts outside of the box that both share: parts elsewhere contribute nothing, however coarse or far away it is.
// With a margin, so that no curve touches the sides of the box that the other one runs along.
CommonArea of_regions(const ClosedCurve& whole1, const ClosedCurve& whole2) {
  const Box box1 = box_of(whole1.points()), box2 = box_of(whole2.points());
  Rectangle both{std::max(box1.min_x(), box2.min_x()), std::max(box1.min_y(), box2.min_y()),
                 std::min(box1.max_x(), box2.max_x()), std::min(box1.max_y(), box2.max_y())};
  if (both.empty()) return {};
  const double margin_x = both.width() / 64, margin_y = both.height() / 64;
  both = {both.min_x - margin_x, both.min_y - margin_y, both.max_x + margin_x, both.max_y + margin_y};
  const auto cut = [&](const ClosedCurve& whole, const Box& box) {
    const bool inside = box.min_x() >= both.min_x && box.max_x() <= both.max_x && box.min_y() >= both.min_y &&
                        box.max_y() <= both.max_y;
    if (inside) return whole;
    return ClosedCurve(cut_outside(whole.points(), both, fitted_beside));
  };
  const ClosedCurve first = cut(whole1, box1), second = cut(whole2, box2);
  if (!bounds_something(first.points()) || !bounds_something(second.points())) return {};
  const Regions found = regions(first, second);
  double polygons = 0, most = 0;
  for (const WindingArea& entry : found.table()) {
    polygons += entry.w1 * entry.w2 * entry.area;
    most += std::abs(entry.w1 * entry.w2) * entry.area;
  }
  const int exponent = scaling_exponent(union_of(box_of(first.points()), box_of(second.points())));
  const auto rescaled = [&](const ClosedCurve& curve) {
    return exponent == 0 ? curve : ClosedCurve(scaled(curve, exponent));
  };
  const ClosedCurve scaled1 = rescaled(first), scaled2 = rescaled(second);
  const IndexedCurve own(scaled1), others(scaled2);
  const CommonArea along1 = AlongAnother(own, others, exponent).chord_areas();
  const CommonArea along2 = AlongAnother(others, own, exponent).chord_areas();
  return {polygons + along1.area + along2.area, found.rounding(most) + along1.error + along2.error};
}

}  // namespace

CommonArea winding_product(const ClosedCurve& first, const ClosedCurve& second) {
  if (!bounds_something(first.points()) || !bounds_something(second.points())) return {};
  try {
    OverlayOptions options;
    options.pieces = false;
    const Overlay both = overlay(first, second, options);
    if (both.nodes.size() == 0 && both.areas.intersection == 0) return {};
    const SmoothAreas smooth = smooth_areas(both);
    const bool same_way = (signed_area(first) < 0) == (signed_area(second) < 0);
    return {same_way ? smooth.areas.intersection : -smooth.areas.intersection, smooth.error.intersection};
  } catch (const NotSimpleError&) {
    return of_regions(first, second);
  }
}

}  // namespace lober
