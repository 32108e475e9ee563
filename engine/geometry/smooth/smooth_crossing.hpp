// The crossing of two smooth curves near a crossing of their polygons (private to smooth/).
#pragma once

#include <optional>

#include "engine/geometry/crossings/contacts.hpp"
#include "engine/geometry/smooth/smooth_curve.hpp"

namespace lober::detail {

struct SmoothCrossing {
  SmoothPosition position1, position2;
};

/// The terms that one contact adds to the running sums of chord-to-arc areas before its two segments, so that they
/// reach the point where both curves pass; `uncertainty` is twice the area that may hide where the smooth curves do not
/// meet in that point, and the errors of the two segments.
struct EndOfArcs {
  double on1 = 0, on2 = 0;
  double uncertainty = 0;
};

/// A point that moves along a smooth curve. Coordinates are relative to `origin`, a vertex near by.
class Runner {
 public:
  Runner(const SmoothCurve& curve, SmoothPosition position, Point origin)
      : curve_(&curve), start_(position.segment), origin_(origin), u_(position.u) {
    enter(position.segment);
  }
  [[nodiscard]] Point at() const { return vertex_ + shape_.at(u_); }
  [[nodiscard]] Point velocity() const { return shape_.velocity(u_); }
  [[nodiscard]] SmoothPosition position() const { return {segment_, u_}; }
  [[nodiscard]] const SmoothSegment& shape() const { return shape_; }

  /// False when that leads too far: more than two segments on either side.
  [[nodiscard]] bool move(double step);

 private:
  void enter(std::int64_t segment) {
    segment_ = segment;
    shape_ = curve_->segment(segment);
    vertex_ = curve_->vertex(segment) - origin_;
  }

  const SmoothCurve* curve_;
  std::int64_t start_, segment_ = 0;
  Point origin_, vertex_;
  double u_;
  SmoothSegment shape_;
};

/// A contact of two polygons on the smooth curves through them. Each curve is fitted once for all that is asked.
class SmoothContact {
 public:
  SmoothContact(const SmoothCurve& c1, const SmoothCurve& c2, const Contact& contact)
      : c1_(c1),
        c2_(c2),
        origin_(c1.vertex(contact.segment1)),
        here1_{contact.segment1, contact.t1.hi},
        here2_{contact.segment2, contact.t2.hi},
        on1_(c1, here1_, origin_),
        on2_(c2, here2_, origin_) {}

  /// Whether neither curve leaves its segment, so that the contact of the polygons is right as it is.
  [[nodiscard]] bool straight() const {
    return on1_.shape().kind != SmoothSegment::Kind::smooth && on2_.shape().kind != SmoothSegment::Kind::smooth;
  }

  /// Moves to where the smooth curves cross: Newton's iteration in the two parameters from the contact of the polygons,
  /// over at most two segments on either side. The crossing; nothing, and all stays as it is, unless it converges to a
  /// point where C2 passes C1 in the given sense (from right to left, as the input runs).
  std::optional<SmoothCrossing> move_to_crossing(bool rightward_to_left);

  /// The end of arcs at the crossing, or at the contact where nothing has moved. The sum of (v_i - o) x (v_{i+1} - o)
  /// up to the common point Q less that of the polygon up to its contact P is that of the loop from P along the polygon
  /// to the segment of Q, along the smooth curve to Q and straight back, and P x Q, which is left out: it is the same
  /// for both curves and cancels in every region.
  [[nodiscard]] EndOfArcs ends() const;

 private:
  const SmoothCurve &c1_, &c2_;
  Point origin_;
  SmoothPosition here1_, here2_;  // the contact of the polygons
  Runner on1_, on2_;
  bool moved_ = false;
};

}  // namespace lober::detail
