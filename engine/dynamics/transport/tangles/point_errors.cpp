#include "engine/dynamics/transport/tangles/point_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/manifolds/iterate_each.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/point.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t points_sampled = 64;  // as many up to the bip, and from there on
constexpr int max_comparisons = 6;
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

// Number of the piece of a grown manifold that a vertex is in.
int generation_of(const GrownManifold& grown, std::size_t vertex) {
  const auto after = std::upper_bound(grown.generation_begin.begin(), grown.generation_begin.end(), vertex);
  return static_cast<int>(after - grown.generation_begin.begin()) - 1;
}

// A point of a grown manifold, and the parameter whose image, computed more finely, is to lie beside it.
struct Sample {
  std::size_t vertex = 0;  // that was sampled
  std::size_t beside = 0;  // that the image lies beside
  double parameter = 0;
  int generation = 0;
  double off = 0;  // across the curve
  bool done = false;
};

// Between the first vertex and the one called last, at even distances up to the middle and from there on.
std::vector<Sample> samples_of(const GrownManifold& grown, std::size_t middle, std::size_t last, const Box& box) {
  std::vector<Sample> samples;
  const auto add = [&](std::size_t begin, std::size_t end) {
    std::size_t before = 0;
    for (std::size_t k = 1; k <= points_sampled; ++k) {
      const std::size_t vertex = begin + k * (end - begin) / points_sampled;
      if (vertex == before || vertex == 0 || vertex + 1 >= grown.points.size()) continue;
      before = vertex;
      if (!meet(Box::of(grown.points[vertex], grown.points[vertex]), box)) continue;
      samples.push_back({vertex, vertex, grown.parameters[vertex], generation_of(grown, vertex)});
    }
  };
  add(0, middle);
  if (last > middle) add(middle, last);
  return samples;
}

// The vertex, not the first or the last one, that is nearest to a point.
std::size_t nearest(const Buffer<Point>& points, Point to) {
  std::size_t found = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const double dx = points[k].x - to.x, dy = points[k].y - to.y, square = dx * dx + dy * dy;
    if (square < least) least = square, found = k;
  }
  return found;
}

// Compares the samples with their finer images. Errors of an orbit along the manifold grow as fast as it is stretched,
// and do not move it: a sample whose image is farther along than its neighbours is compared with the vertex that is
// nearest to that, and with another parameter next time.
void compare(const PlanarMap& finer, const LocalManifold& local, const GrownManifold& grown,
             std::span<Sample> samples) {
  const LocalManifold::Image image = local.image();
  std::vector<Point> exact;
  std::vector<int> iterates;
  for (const Sample& sample : samples) {
    exact.push_back(local.at(sample.parameter));
    iterates.push_back(sample.generation * image.steps);
  }
  for_each_block(samples.size(), std::max(std::size_t{16}, finer.batch()), [&](std::size_t begin, std::size_t end) {
    iterate_each(finer, std::span(exact).subspan(begin, end - begin), std::span(iterates).subspan(begin, end - begin));
  });
  for_each_block(samples.size(), 1, [&](std::size_t k, std::size_t) {
    Sample& sample = samples[k];
    const auto chords_to = [&](std::size_t vertex) {  // x: how many chords along the curve, y: how far across it
      const Point before = grown.points[vertex - 1], next = grown.points[vertex + 1], here = grown.points[vertex];
      const Point chord{next.x - before.x, next.y - before.y}, away{exact[k].x - here.x, exact[k].y - here.y};
      const double size = length(chord);
      return Point{(away.x * chord.x + away.y * chord.y) / (size * size),
                   std::fabs(chord.x * away.y - chord.y * away.x) / size};
    };
    const auto parameter_of = [&](std::size_t vertex) {
      double parameter = grown.parameters[vertex];
      for (int g = generation_of(grown, vertex); g > sample.generation; --g) parameter *= image.factor;
      for (int g = generation_of(grown, vertex); g < sample.generation; ++g) parameter /= image.factor;
      return parameter;
    };
    Point off = chords_to(sample.beside);
    if (is_finite(off) && std::fabs(off.x) > 1) {
      sample.beside = nearest(grown.points, exact[k]);
      off = chords_to(sample.beside);
    }
    if (!is_finite(off)) {
      sample.done = true;
      return;
    }
    sample.off = off.y;
    sample.done = std::fabs(off.x) <= 1e-3;
    const double moved = sample.parameter - off.x * (parameter_of(sample.beside + 1) - parameter_of(sample.beside - 1));
    if (std::fabs(moved) <= local.reach) sample.parameter = moved;
  });
}

}  // namespace

PointErrors::PointErrors(const PlanarMap& map, const LocalManifold& local, const GrownManifold& grown,
                         std::size_t middle, std::size_t last, const Box& box) {
  double largest = 0;
  for (const Point p : grown.points) {
    if (meet(Box::of(p, p), box)) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  rounding_ = roundings * std::numeric_limits<double>::epsilon() * largest + local.defect_across;
  const auto finer = map.finer();
  if (!finer || grown.points.size() < 3) return;
  std::vector<Sample> samples = samples_of(grown, middle, last, box);
  std::span<Sample> left = samples;
  for (int round = 0; round < max_comparisons && !left.empty(); ++round) {
    compare(*finer, local, grown, left);
    const auto open = std::partition(left.begin(), left.end(), [](const Sample& sample) { return sample.done; });
    left = {open, left.end()};
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.vertex < b.vertex; });
  double off = 0;
  for (const Sample& sample : samples) {
    off = std::max(off, sample.off);
    up_to_.emplace_back(sample.vertex, off);
  }
}

double PointErrors::up_to(std::size_t vertex) const {
  if (up_to_.empty()) return rounding_;
  const auto after = std::upper_bound(up_to_.begin(), up_to_.end(), vertex,
                                      [](std::size_t wanted, const auto& entry) { return wanted < entry.first; });
  return rounding_ + 2 * (after == up_to_.begin() ? after : std::prev(after))->second;
}

void add_point_errors(const PlanarMap& map, const Box& box, ManifoldTangle& manifolds) {
  Tangle& tangle = manifolds.tangle;
  if (tangle.pips.empty()) return;
  const Pip& bip = tangle.pips[manifolds.bip];
  const PointErrors of_u(map, manifolds.local_u, manifolds.u, bip.u.segment, tangle.pips.back().u.segment, box);
  const PointErrors of_s(map, manifolds.local_s, manifolds.s, bip.s.segment, tangle.pips.front().s.segment, box);
  for (const Pip& pip : tangle.pips) {
    manifolds.point_errors_u.push_back(of_u.up_to(pip.u.segment));
    manifolds.point_errors_s.push_back(of_s.up_to(pip.s.segment));
  }
  const std::vector<double>&errors_u = manifolds.point_errors_u, &errors_s = manifolds.point_errors_s;
  const Lengths along_u(manifolds.u.points), along_s(manifolds.s.points);
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
    const Pip &first = tangle.pips[k], &last = tangle.pips[k + 1];
    tangle.lobes[k].smooth_error += errors_u[k + 1] * (along_u.to(last.u) - along_u.to(first.u)) +
                                    errors_s[k] * (along_s.to(first.s) - along_s.to(last.s));
  }
  if (!tangle.boundary) return;
  const std::size_t end = tangle.boundary->bip;
  const double boundary =
      errors_u[end] * along_u.to(tangle.pips[end].u) + errors_s[end] * along_s.to(tangle.pips[end].s);
  tangle.boundary->smooth_error += boundary;
  for (Lobe& lobe : tangle.lobes) {
    if (lobe.inside > 0 && lobe.outside > 0) lobe.boundary_error += boundary;
  }
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
  double sides = 0;  // signed sum of the turnstile's lobes
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
