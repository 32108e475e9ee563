// The box in which the manifolds of a tangle are followed exactly, and how far distances are true (private to
// transport/).
#pragma once

#include <span>

#include "kernels/box.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/local_manifold.hpp"

namespace lober::detail {

/// The box in which manifolds are followed exactly is larger than that of the saddles and the local manifolds by this.
inline constexpr double times_scene = 17;

/// The box where manifolds have to be as fine as asked: the saddles, their local manifolds, and eight times as far.
/// Curves farther out are on their way out and followed coarsely.
[[nodiscard]] Box scene(const LocalManifold& u, const LocalManifold& s);

/// Orbits that escape leave any scale behind in a few steps. Beyond many times the size of the box distances from its
/// middle are made logarithmic: a homeomorphism of the plane, so that nothing crosses that did not.
void compress_radially(std::span<Point> points, const Box& box);
/// The box where `compress_radially` changes nothing.
[[nodiscard]] Box true_size(const Box& box);

/// The box with 65 536 translates on either side: no manifold leaves it along the lattice.
[[nodiscard]] Box strip_along(const Box& box, Point lattice);

[[nodiscard]] Point middle_of(const Box& box);
[[nodiscard]] Box square_about(Point middle, double reach);
[[nodiscard]] bool within(const Box& inner, const Box& outer);

}  // namespace lober::detail
