// The crossings of two smooth curves near those of their polygons (private to smooth/).
#pragma once

#include <cstdint>
#include <span>

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/smooth/smooth_curve.hpp"
#include "kernels/smooth_approach.hpp"

namespace lober::detail {

/// A contact of two polygons.
struct PolygonContact {
  std::uint32_t segment1, segment2;
  double t1, t2;
  enum class Sense : std::uint8_t { stays, rightward_to_left, leftward_to_right };
  Sense sense;  ///< how C2 passes C1 there, as the input runs, if it is a crossing that is to be moved
};
[[nodiscard]] inline PolygonContact polygon_contact(const Contact& at, PolygonContact::Sense sense) {
  return {at.segment1, at.segment2, at.t1.hi, at.t2.hi, sense};
}
/// The sense of a crossing.
[[nodiscard]] inline PolygonContact::Sense sense_of(std::uint8_t rotation) {
  return rotation == rightward_to_left ? PolygonContact::Sense::rightward_to_left
                                       : PolygonContact::Sense::leftward_to_right;
}

/// A contact of two polygons on the smooth curves through them.
struct SmoothContact {
  SmoothPosition on1, on2;  ///< where the smooth curves cross; the contact of the polygons where nothing has moved
  EndOfArcs ends;
  bool moved;
  bool straight;  ///< whether neither curve leaves its segment, so that the contact of the polygons is right as it is
};

/// Moves contacts to where the smooth curves cross: Newton's iteration in the two parameters from the contact of the
/// polygons, over at most two segments on either side. A contact stays where it is unless that converges to a point
/// where C2 passes C1 in the given sense, and if it is straight, unless `straight_too`. Many at once: neighbours along
/// the curves share their segments' shapes.
///
/// The ends of arcs are those at the crossing, or at the contact where nothing has moved. The sum of (v_i - o) x
/// (v_{i+1} - o) up to the common point Q less that of the polygon up to its contact P is that of the loop from P along
/// the polygon to the segment of Q, along the smooth curve to Q and straight back, and P x Q, which is left out: it is
/// the same for both curves and cancels in every region.
void move_contacts(const SmoothCurve& c1, const SmoothCurve& c2, std::span<const PolygonContact> contacts,
                   bool straight_too, std::span<SmoothContact> moved);

}  // namespace lober::detail
