// Which segments of a polyline have to be looked at one by one, and why.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box.hpp"
#include "kernels/point.hpp"
#include "kernels/turning.hpp"

namespace lober::detail {

/// Segments in a row are handed over in no more than this number at a time.
inline constexpr std::size_t max_flagged = 256;

/// Bits of a segment that a polyline through points of a smooth curve may have to cut. Segments without any are most.
inline constexpr std::int64_t unknown_segment = 1;  ///< both ends are corners: nothing shows how the curve bends there
inline constexpr std::int64_t uneven_segment = 2;   ///< its length per parameter is not that of its neighbours
inline constexpr std::int64_t outside_segment = 4;  ///< an end is not in the box, or not finite
inline constexpr std::int64_t coarse_segment = 8;   ///< requires more parts than `coarse`
inline constexpr std::int64_t rough_segment = 16;  ///< requires more than `rough`, or is sharp and requires more than 1

struct SegmentBounds {
  Box box;
  double visible;     ///< segments that are shorter are never uneven
  double unevenness;  ///< ratio of lengths per parameter from which neighbours are uneven
  double coarse;      ///< parts
  double rough;       ///< parts
  double sharp;       ///< curvature times length, radians
};

/// `count` segments, at most max_flagged, between points[0] and points[count]. A segment has neighbours: lengths[0] is
/// that of the segment before the first one, lengths[count + 1] of that behind the last one.
struct SegmentRow {
  const Point* points;
  const double* parameters;    ///< as the points
  bool has_before, has_after;  ///< whether there are parameters[-1] and parameters[count + 1]
  const double* lengths;
  const double* bends;  ///< curvatures at the points; negative at corners
  const double* parts;  ///< required ones
  std::size_t count;
};

/// Sets flags[k] for each segment, and returns the bits that any of them has.
std::int64_t flag_segments(const SegmentRow& row, const SegmentBounds& bounds, std::int64_t* flags);

/// A row as above, before anything is known about it but its points: points[-1] and points[count + 1] are there where
/// has_before and has_after say so.
struct PointRow {
  const Point* points;
  const double* parameters;
  bool has_before, has_after;
  std::size_t count;
};
/// True only where flag_segments, given what turns_along and parts_needed make of the row, would call no segment
/// outside, uneven or coarse; false where that is not sure. Without a root or a division, so that it costs a third of
/// them: with u and v the segments at a vertex, curvature is at most 2 |u x v| / (u.v |u + v|) where u.v > 0.
bool surely_fine(const PointRow& row, const SegmentBounds& bounds, PartsAsked asked);

struct LengthInBox {
  double sum;
  bool inside;
};
/// The sum of the lengths of `count` segments, at most max_flagged, and whether both ends of each are in the box.
LengthInBox length_in_box(const Point* points, std::size_t count, const Box& box);

}  // namespace lober::detail
