#include "engine/dynamics/transport/tangles/point_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/manifolds/iterate_each.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/point.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t points_sampled = 64;
// A computed point is off by this number of roundings of its coordinates where nothing is integrated.
constexpr double roundings = 4;

// The lengths of a polyline from its beginning to each of the positions, which ascend in `order`.
class Lengths {
 public:
  explicit Lengths(const Buffer<Point>& points) : points_(points), sums_(points.size()) {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      sums_[k] = sum;
      sum += distance(points[k], points[k + 1]);
    }
    if (!sums_.empty()) sums_.back() = sum;
  }
  [[nodiscard]] double to(Position at) const {
    const std::size_t next = std::min<std::size_t>(at.segment + 1, points_.size() - 1);
    return sums_[at.segment] + at.t * distance(points_[at.segment], points_[next]);
  }

 private:
  const Buffer<Point>& points_;
  Buffer<double> sums_;
};

}  // namespace

double point_error(const PlanarMap& map, const LocalManifold& local, const GrownManifold& grown, const Box& box) {
  double largest = 0;
  const auto within = [&](Point p) { return meet(Box::of(p, p), box); };
  for (const Point p : grown.points) {
    if (within(p)) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  const double rounding = roundings * std::numeric_limits<double>::epsilon() * largest + local.defect_across;
  const auto finer = map.finer();
  if (!finer || grown.points.size() < 3) return rounding;
  const LocalManifold::Image image = local.image();
  std::vector<std::size_t> chosen;
  std::vector<Point> exact;
  std::vector<int> iterates;
  for (std::size_t k = 0; k < points_sampled; ++k) {
    const std::size_t at = 1 + k * (grown.points.size() - 2) / points_sampled;
    if (!within(grown.points[at])) continue;
    const auto after = std::upper_bound(grown.generation_begin.begin(), grown.generation_begin.end(), at);
    const auto generation = static_cast<int>(after - grown.generation_begin.begin()) - 1;
    chosen.push_back(at);
    exact.push_back(local.at(grown.parameters[at]));
    iterates.push_back(generation * image.steps);
  }
  for_each_block(chosen.size(), std::max(std::size_t{16}, map.batch()), [&](std::size_t begin, std::size_t end) {
    iterate_each(*finer, std::span(exact).subspan(begin, end - begin), std::span(iterates).subspan(begin, end - begin));
  });
  double off = 0;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const std::size_t at = chosen[k];
    const Point before = grown.points[at - 1], next = grown.points[at + 1], here = grown.points[at];
    const Point along{next.x - before.x, next.y - before.y};
    const double size = length(along);
    if (!(size > 0) || !is_finite(exact[k])) continue;
    off = std::max(off, std::fabs(along.x * (exact[k].y - here.y) - along.y * (exact[k].x - here.x)) / size);
  }
  return rounding + 2 * off;
}

void add_point_errors(ManifoldTangle& manifolds) {
  Tangle& tangle = manifolds.tangle;
  if (tangle.pips.empty()) return;
  const Lengths along_u(manifolds.u.points), along_s(manifolds.s.points);
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
    const Pip &first = tangle.pips[k], &last = tangle.pips[k + 1];
    tangle.lobes[k].smooth_error += manifolds.point_error_u * (along_u.to(last.u) - along_u.to(first.u)) +
                                    manifolds.point_error_s * (along_s.to(first.s) - along_s.to(last.s));
  }
  if (!tangle.boundary) return;
  const Pip& bip = tangle.pips[tangle.boundary->bip];
  tangle.boundary->smooth_error +=
      manifolds.point_error_u * along_u.to(bip.u) + manifolds.point_error_s * along_s.to(bip.s);
}

void add_errors_far_outside(ManifoldTangle& manifolds) {
  Tangle& tangle = manifolds.tangle;
  const auto arc_leaves = [](const Buffer<Point>& points, const Box& box, Position first, Position last) {
    for (std::size_t k = first.segment + 1; k <= last.segment; ++k) {
      if (!meet(Box::of(points[k], points[k]), box)) return true;
    }
    return false;
  };
  // On which side of U a lobe lies follows from how the pip before it crosses; the sign of an area that is pure error
  // does not tell.
  double sides = 0;  // of the turnstile
  for (std::size_t k = manifolds.image_of_bip(-1); k < manifolds.bip; ++k) {
    sides += tangle.lobes[k].area * tangle.pips[k].rho;
  }
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
    const Pip &first = tangle.pips[k], &last = tangle.pips[k + 1];
    const auto leaves = [&](const Box& box) {
      return arc_leaves(manifolds.u.points, box, first.u, last.u) ||
             arc_leaves(manifolds.s.points, box, last.s, first.s);
    };
    if (!leaves(box_of(manifolds.fine))) continue;
    Lobe& lobe = tangle.lobes[k];
    lobe.smooth_error +=
        leaves(box_of(manifolds.true_size)) ? std::numeric_limits<double>::infinity() : std::fabs(lobe.area);
    if (sides * first.rho * lobe.area < 0) {
      lobe.area = -lobe.area;
      lobe.polygon_area = -lobe.polygon_area;
    }
  }
}

}  // namespace lober::detail
