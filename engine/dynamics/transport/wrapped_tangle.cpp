#include "engine/dynamics/transport/wrapped_tangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/base/text.hpp"
#include "lober/error.hpp"

namespace lober::detail {
namespace {

WrappedTangle wrapped_to(const Cylinder& cylinder, const PlanarMap& map, const ManifoldTangle& manifolds,
                         double tolerance) {
  WrappedTangle result;
  result.u = wrapped(cylinder, map, manifolds.local_u, manifolds.u, tolerance);
  result.s = wrapped(cylinder, map, manifolds.local_s, manifolds.s, tolerance);
  // One and the same saddle, to the bit: else they might cross there.
  if (distance(result.u[0], result.s[0]) <= 1e-8 * (1 + std::fabs(result.u[0].x))) result.s[0] = result.u[0];
  TangleOptions options;
  options.bip_near = cylinder.wrap(manifolds.orbits.back().at);
  options.period = static_cast<std::uint32_t>(manifolds.period());
  options.smooth = true;
  options.closure = manifolds.tangle.closure;
  const OpenCurve u = OpenCurve::borrow(result.u), s = OpenCurve::borrow(result.s);
  try {
    result.tangle = std::make_unique<Tangle>(tangle(u, s, options));
  } catch (const NotSimpleError&) {  // arcs closer to each other than polygons show
    options.check_simple = false;
    result.tangle = std::make_unique<Tangle>(tangle(u, s, options));
  }
  if (!result.tangle->boundary) throw DataError("transport: the manifolds do not cross on the cylinder");
  return result;
}

bool has_pips_of_plane(const Cylinder& cylinder, const WrappedTangle& wrapped, const ManifoldTangle& manifolds,
                       int before, int after) {
  const Barrier barrier = barrier_of(manifolds, wrapped);
  if (barrier.images_before() < before || barrier.images_after() < after) return false;
  const auto period = static_cast<std::ptrdiff_t>(barrier.period);
  for (std::ptrdiff_t k = -before * period; k <= after * period; ++k) {
    const auto number = [&](std::size_t bip) { return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(bip) + k); };
    const Point there = cylinder.wrap(manifolds.tangle.pips[number(manifolds.bip)].at);
    if (!(distance(wrapped.tangle->pips[number(barrier.bip)].at, there) <= 1e3 * manifolds.tolerance)) return false;
  }
  return true;
}

}  // namespace

Cylinder cylinder_of(Point lattice, std::span<const ManifoldTangle* const> tangles) {
  double low = 0, high = 0;
  for (const ManifoldTangle* const tangle : tangles) {
    for (const GrownManifold* const grown : {&tangle->u, &tangle->s}) {
      for (const Point& point : grown->points) {
        const double height = Cylinder::height(lattice, point);
        low = std::min(low, height);
        high = std::max(high, height);
      }
    }
  }
  return {lattice, -low + 0.25 * std::max(high - low, length(lattice))};
}

WrappedTangle wrapped_tangle(const Cylinder& cylinder, const PlanarMap& map, const ManifoldTangle& manifolds,
                             int before, int after, double allowance) {
  constexpr int max_refinements = 5;
  const double more = std::sqrt(10.0);  // points, of a tenth of the tolerance
  std::optional<WrappedTangle> coarser;
  for (int k = 0; k <= max_refinements; ++k) {
    const std::uint64_t work_before = map.work();
    WrappedTangle found = wrapped_to(cylinder, map, manifolds, manifolds.tolerance / std::pow(10, k));
    const auto work = static_cast<double>(map.work() - work_before);
    if (!has_pips_of_plane(cylinder, found, manifolds, before, after)) continue;
    // Straight segments of the plane are bent on the cylinder. Where arcs lie closer to each other than chords are off,
    // secondary crossings come and go, whole strips of lobes with them, and pips do not tell.
    if (coarser && coarser->tangle->nodes.crossings() == found.tangle->nodes.crossings()) {
      coarser->has_all_crossings = true;
      return std::move(*coarser);
    }
    allowance -= work;
    if (k == max_refinements || more * work > allowance) return found;
    coarser.emplace(std::move(found));
  }
  throw DataError(
      "transport: on the cylinder manifolds cross elsewhere than in the plane, by those of the neighbouring "
      "cells or because they lie too close to each other: the bip " +
      format_point(manifolds.orbits.back().at) + " bounds no region of it");
}

Barrier barrier_of(const ManifoldTangle& manifolds) {
  Barrier barrier;
  barrier.tangle = &manifolds.tangle;
  barrier.bip = manifolds.bip;
  barrier.period = manifolds.period();
  barrier.curve_error = std::max(manifolds.point_error_u, manifolds.point_error_s);
  barrier.lobes_include_it = true;
  barrier.fine = box_of(manifolds.fine);
  barrier.true_size = box_of(manifolds.true_size);
  return barrier;
}

Barrier barrier_of(const ManifoldTangle& manifolds, const WrappedTangle& wrapped) {
  // Points that are added where circles bend lie unevenly, and the smooth curves through them are worse than their
  // error estimates: by up to a thousandth of the tolerance, measured on the standard map for K = 0.4 to 5.
  constexpr double unevenness = 2e-3;
  Barrier barrier;
  barrier.tangle = wrapped.tangle.get();
  barrier.bip = wrapped.tangle->boundary->bip;
  barrier.period = manifolds.period();
  barrier.curve_error = std::max(manifolds.point_error_u, manifolds.point_error_s) + unevenness * manifolds.tolerance;
  return barrier;
}

}  // namespace lober::detail
