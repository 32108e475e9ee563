#include "engine/dynamics/transport/turnstile/cylinder.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::detail {
namespace {

// Translates to one side that a tangle may meet.
std::size_t copies_in_reach(const Barrier& barrier) {
  if (barrier.lattice == Point{}) return 0;
  return translates_in_reach(barrier.tangle->u().points, barrier.tangle->s().points, barrier.lattice);
}

std::vector<Point> moved(const std::vector<Point>& points, Point lattice, int times) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Point point : points) result.push_back(detail::moved(point, lattice, times));
  return result;
}

// The region below a boundary that runs round, over the reach `over` along the lattice: with copies so far on either
// side that no other one, and no end, reaches there. `arcs` is its outline.
std::vector<Point> region_below(const Barrier& barrier, const std::vector<Point>& arcs, Reach over, double bottom) {
  const Reach copy = reach_of(arcs, barrier.lattice);
  const int first = static_cast<int>(std::floor(over.from - copy.to)) - 1;
  const int last = static_cast<int>(std::ceil(over.to - copy.from)) + 1;
  return region_below(barrier, first, last, bottom);
}

}  // namespace

double lowest(const std::vector<Point>& points, Point lattice) {
  const AlongLattice along(lattice);
  double low = along(points.front()).y;
  for (const Point point : points) low = std::min(low, along(point).y);
  return low;
}

std::vector<Point> region_below(const Barrier& barrier, int first, int last, double bottom) {
  const Point lattice = barrier.lattice;
  std::vector<Point> copy = outline_of(barrier, 0);
  if (turns_of(barrier) > 0) std::reverse(copy.begin(), copy.end());
  copy.pop_back();  // the next copy begins there
  // Runs from the right to the left, as the inside of a region that is below demands.
  std::vector<Point> polygon;
  polygon.reserve(copy.size() * static_cast<std::size_t>(last - first + 1) + 3);
  for (int k = last; k >= first; --k) {
    const std::vector<Point> points = moved(copy, lattice, k);
    polygon.insert(polygon.end(), points.begin(), points.end());
  }
  const Point right = polygon.front();
  const Point left{copy.front().x + (first - 1) * lattice.x, copy.front().y + (first - 1) * lattice.y};
  polygon.push_back(left);
  const double period = length(lattice);
  const Point up{-lattice.y / period, lattice.x / period};
  for (const Point end : {left, right}) {
    const double down = along_and_above(lattice, end).y - bottom;
    polygon.push_back({end.x - down * up.x, end.y - down * up.y});
  }
  return polygon;
}

ProductOnCylinder product_on_cylinder(const std::vector<Point>& first, const std::vector<Point>& second,
                                      Point lattice) {
  if (first.size() < 3 || second.size() < 3) return {};
  if (lattice == Point{}) return {{product_of_windings(first, second)}};
  const Reach one = reach_of(first, lattice), other = reach_of(second, lattice);
  const int from = static_cast<int>(std::ceil(one.from - other.to));
  const int to = static_cast<int>(std::floor(one.to - other.from));
  if (to < from) return {};
  ProductOnCylinder product{std::vector<WindingProduct>(static_cast<std::size_t>(to - from + 1))};
  for_each_block(product.terms.size(), 1, [&](std::size_t term, std::size_t) {
    const int k = from + static_cast<int>(term);
    product.terms[term] =
        k == 0 ? product_of_windings(first, second) : product_of_windings(first, moved(second, lattice, k));
  });
  return product;
}

ProductOnCylinder product_with_inside(const std::vector<Point>& polygon, const Barrier& barrier) {
  if (polygon.size() < 3) return {};
  const Point lattice = barrier.lattice;
  if (turns_of(barrier) == 0) {
    ProductOnCylinder product = product_on_cylinder(polygon, outline_of(barrier, 0), lattice);
    product.sign = sign_of(barrier);
    return product;
  }
  const std::vector<Point> arcs = outline_of(barrier, 0);
  const double low = std::min(lowest(polygon, lattice), lowest(arcs, lattice));
  const std::vector<Point> below = region_below(barrier, arcs, reach_of(polygon, lattice), low - length(lattice));
  return {{product_of_windings(polygon, below)}};
}

Measured area_in_common(const std::vector<Point>& first, const std::vector<Point>& second, double curve_error,
                        Point lattice) {
  const Measured product = product_on_cylinder(first, second, lattice).with(curve_error);
  return {std::fabs(product.value), product.error};
}

Measured area_inside(const std::vector<Point>& polygon, const Barrier& barrier, double curve_error) {
  const Measured product = product_with_inside(polygon, barrier).with(curve_error);
  return {std::fabs(product.value), product.error};
}

double area_below_both(const Barrier& c, const Barrier& d, double bottom) {
  const Reach one = reach_of(outline_of(c, 0), c.lattice), other = reach_of(outline_of(d, 0), d.lattice);
  // From this number of copies on one more adds a period: the ends of the polygons do not see each other.
  const int copies = static_cast<int>(std::ceil(std::max(one.to, other.to) - std::min(one.from, other.from))) + 2;
  const auto area = [&](int last) {
    return product_of_windings(region_below(c, 0, last, bottom), region_below(d, 0, last, bottom)).area;
  };
  double more = 0, fewer = 0;
  parallel_if(
      true, [&] { more = area(copies + 1); }, [&] { fewer = area(copies); });
  return more - fewer;
}

InsideOfBarrier::InsideOfBarrier(const Barrier& barrier)
    : lattice_(barrier.lattice), runs_round_(turns_of(barrier) != 0), polygon_(outline_of(barrier, 0)) {
  if (lattice_ == Point{}) {
    box_ = box_of(polygon_);
  } else {
    const AlongLattice along(lattice_);
    for (const Point point : polygon_) {
      const Point at = along(point);
      box_ = union_of(box_, Box::of(at, at));
    }
    if (runs_round_) {
      bottom_ = box_.min_y() - length(lattice_);
      polygon_ = region_below(barrier, polygon_, {0, 1}, bottom_ - length(lattice_));
    } else {
      const Reach reach = reach_of(polygon_, lattice_);
      from_ = reach.from;
      copies_ = 1 + static_cast<int>(std::floor(reach.to - reach.from));
    }
  }
  index_.emplace(CurveView{polygon_});
}

std::vector<bool> InsideOfBarrier::of(std::span<const Point> points) const {
  std::vector<bool> inside(points.size());
  if (lattice_ == Point{}) {
    for (std::size_t k = 0; k < points.size(); ++k) inside[k] = winding(*index_, points[k]).number != 0;
    return inside;
  }
  const AlongLattice along(lattice_);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point at = along(points[k]);
    if (runs_round_ && at.y < bottom_) {
      inside[k] = true;
      continue;
    }
    const double turns = std::floor(at.x / along.period() - from_);
    for (int copy = 0; copy < copies_ && !inside[k]; ++copy) {
      const double back = copy - turns;
      const Point there{points[k].x + back * lattice_.x, points[k].y + back * lattice_.y};
      inside[k] = winding(*index_, there).number != 0;
    }
  }
  return inside;
}

std::vector<LobeOverlap> overlaps_on_cylinder(const Barrier& barrier) {
  const Tangle& tangle = *barrier.tangle;
  std::vector<LobeOverlap> list = overlaps(tangle);
  const std::size_t copies = copies_in_reach(barrier);
  std::vector<CopyOverlaps> found(copies);
  for_each_block(copies, 1, [&](std::size_t k, std::size_t) {
    const auto times = static_cast<double>(k + 1);
    found[k] = overlaps_with_copy(tangle, {times * barrier.lattice.x, times * barrier.lattice.y});
  });
  const std::size_t first = barrier.pip(-barrier.images_before()), last = barrier.pip(barrier.images_after());
  for (const CopyOverlaps& copy : found) {
    for (const std::uint32_t pip : copy.hidden_pips) {
      if (pip < first || pip > last) continue;
      throw DataError("transport: on the cylinder the manifolds of neighbouring cells cross before the pip " +
                      format_point(tangle.pips[pip].at) + ", so that the bip " +
                      format_point(tangle.pips[barrier.bip].at) + " bounds no region of it");
    }
    for (LobeOverlap both : copy.overlaps) {
      // i with a copy of j, and j with a copy of i that was moved the other way.
      if (both.i > both.j) std::swap(both.i, both.j);
      if (both.i == both.j) {
        both.area *= 2;
        both.error *= 2;
        both.perimeter *= 2;
      }
      list.push_back(both);
    }
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const LobeOverlap& x, const LobeOverlap& y) { return x.i != y.i ? x.i < y.i : x.j < y.j; });
  std::vector<LobeOverlap> sums;
  for (const LobeOverlap& one : list) {
    if (sums.empty() || sums.back().i != one.i || sums.back().j != one.j) {
      sums.push_back(one);
      continue;
    }
    sums.back().area += one.area;
    sums.back().error += one.error;
    sums.back().perimeter += one.perimeter;
  }
  return sums;
}

}  // namespace lober::detail
