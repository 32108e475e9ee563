// Boundaries on a cylinder: of a plane in which points a period apart are one and the same.
//
// A boundary B(q) either closes in the plane, and stands for all its translates, or leads from a saddle to its copy a
// period on and runs round the cylinder; its inside is then the region below it, seen along the period. Nothing is
// cut or bent: integrals over the cylinder are sums over translates of integrals over the plane. Let c and c_n be the
// functions that are 1 inside B(q) and f^n(B(q)), and w the winding number of the loop that U and S make from q to
// f^n(q) and back. Then c_n = c + s w summed over translates, with a sign s of the boundary, and
//   int c_m d_n = int c d + s int w d + t int c v + s t int w v,
// w and v the loops of both. How many translates there are follows from how far the loops reach along the period.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/transport/tangles/barrier.hpp"
#include "kernels/box.hpp"
#include "lober/overlay/index.hpp"

namespace lober::detail {

/// The least height of points above the line along a lattice through the origin.
[[nodiscard]] double lowest(const std::vector<Point>& points, Point lattice);

/// The region below copies `first` to `last` of a boundary that runs round, as a closed polygon that runs
/// counter-clockwise, with its bottom at the height `bottom`. O(its vertices).
[[nodiscard]] std::vector<Point> region_below(const Barrier& barrier, int first, int last, double bottom);

/// int w v over a cylinder: a sum over translates, before it is said how far curves may lie from the true ones.
struct ProductOnCylinder {
  std::vector<WindingProduct> terms;  ///< one for each translate
  int sign = 1;
  [[nodiscard]] Measured with(double curve_error) const {
    Measured sum{};
    for (const WindingProduct& term : terms) sum = sum + term.with(curve_error);
    return sign * sum;
  }
};

/// w and v the winding numbers of two closed polygons; in the plane if `lattice` is (0, 0).
[[nodiscard]] ProductOnCylinder product_on_cylinder(const std::vector<Point>& first, const std::vector<Point>& second,
                                                    Point lattice);

/// w the winding number of a closed polygon and v the function that is 1 inside B(q).
[[nodiscard]] ProductOnCylinder product_with_inside(const std::vector<Point>& polygon, const Barrier& barrier);

/// The common area of two closed polygons on the cylinder (`area_in_common` of one and all translates of the other);
/// in the plane if `lattice` is (0, 0).
[[nodiscard]] Measured area_in_common(const std::vector<Point>& first, const std::vector<Point>& second,
                                      double curve_error, Point lattice);

/// The area of a closed polygon inside B(q), each part as often as the polygon winds round it.
[[nodiscard]] Measured area_inside(const std::vector<Point>& polygon, const Barrier& barrier, double curve_error);

/// The area of the cylinder below both c and d, which run round, and above `bottom`, which is below both: by
/// overlay.
[[nodiscard]] double area_below_both(const Barrier& c, const Barrier& d, double bottom);

/// The side of points with respect to B(q), on the cylinder if there is one.
class InsideOfBarrier {
 public:
  explicit InsideOfBarrier(const Barrier& barrier);
  /// For finite points. On the boundary they count as outside. About log N a point.
  [[nodiscard]] std::vector<bool> of(std::span<const Point> points) const;
  /// A box that holds the boundary; on a cylinder, along the lattice and above it.
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  Point lattice_;
  bool runs_round_;
  double bottom_ = 0;  // below that everything is inside of what runs round
  int copies_ = 1;     // that may hold a point that lies less than one period past from_
  double from_ = 0;    // along the lattice, in units of it
  Box box_;
  std::vector<Point> polygon_;
  std::optional<IndexedCurve> index_;
};

/// The copies of the tangle of a barrier that reach its own: what its lobes have in common on the cylinder, i <= j, of
/// i = j with translates only, then counted twice. Throws DataError where pips from f^-before(q) to f^after(q), as far
/// as there are any, are none on the cylinder.
[[nodiscard]] std::vector<LobeOverlap> overlaps_on_cylinder(const Barrier& barrier);

}  // namespace lober::detail
