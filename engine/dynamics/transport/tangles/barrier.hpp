// A curve that bounds a region and that the map carries along: the boundary B(q) of a tangle and what closes it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/dynamics/transport/tangles/along_lattice.hpp"
#include "kernels/box.hpp"
#include "kernels/point.hpp"
#include "lober/tangle/tangle.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail {

/// B(q) = U[p-, q] u S[q, p+], closed by a path from p+ back to p- that the map keeps: walls, an axis, nothing when
/// homoclinic (Tangle::closure). The curve f^k(B(q)) consists of the same manifolds and the same path, with the pip
/// f^k(q) for q. The tangle must outlive it.
struct Barrier {
  const Tangle* tangle = nullptr;
  std::size_t bip = 0;     ///< number of the pip q
  std::size_t period = 0;  ///< pips from one to its image
  /// How far the manifolds may lie from the true ones, beside the error of their polygons: by integration and rounding.
  /// An area is wrong by no more than that times the length of its boundary.
  double curve_error = 0;
  /// The same up to each pip along U and along S, where the manifolds were grown; Lobe::smooth_error contains it then.
  std::span<const double> errors_u{}, errors_s{};
  Point lattice{};  ///< shift after which the plane repeats itself, see cylinder.hpp; (0, 0): none
  /// Where the manifolds are as fine as asked; beyond, they are followed coarsely. Beyond `true_size` distances are not
  /// true either. Empty boxes: everywhere.
  Box fine{}, true_size{};

  /// The distance by which the boundary up to a pip may lie from the true one, and that of a lobe.
  [[nodiscard]] double error_up_to(std::size_t q) const {
    return errors_u.empty() ? curve_error : std::max(errors_u[q], errors_s[q]);
  }
  [[nodiscard]] double error_of_lobe(std::size_t lobe) const {
    return errors_u.empty() ? curve_error : std::max(errors_u[lobe + 1], errors_s[lobe]);
  }

  /// The number of images of q, forward and back, among the pips.
  [[nodiscard]] int images_after() const { return static_cast<int>((tangle->pips.size() - 1 - bip) / period); }
  [[nodiscard]] int images_before() const { return static_cast<int>(bip / period); }
  /// The number of the pip f^k(q); also of the first lobe after it.
  [[nodiscard]] std::size_t pip(int k) const {
    return bip + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(period) * k);
  }
};

/// The boundary of a tangle whose plane repeats itself after `lattice`. Valid as long as the tangle is.
[[nodiscard]] Barrier barrier_of(const ManifoldTangle& manifolds, Point lattice);

/// The number of turns of a boundary round its cylinder: +1 or -1, along the lattice or against it; 0 where it closes,
/// in the plane always. Throws DataError where it runs round more than once.
[[nodiscard]] int turns_of(const Barrier& barrier);
/// +1 where the inside lies on the left of U and S as B(q) follows them, from p- to p+.
[[nodiscard]] int sign_of(const Barrier& barrier);
/// f^k(B(q)) as a closed polygon; as an open one where it runs round a cylinder, from p- to p+. O(its vertices).
[[nodiscard]] std::vector<Point> outline_of(const Barrier& barrier, int k);

/// Possible error of an area that this outline bounds because arcs through its points are fitted across the pip where
/// it passes from U to S, as if it did not turn there: 0 where it turns so much that the fit shows it as a corner.
[[nodiscard]] double error_at_corner(const Barrier& barrier, int k);

/// Whether the path that closes f^k(B(q)) meets the rest of it elsewhere than at the saddles. Then it bounds nothing.
[[nodiscard]] bool closure_is_crossed(const Barrier& barrier, int k);

/// Whether the tangle says that about B(q), and measured what it winds round.
[[nodiscard]] bool crosses_itself(const Barrier& barrier);
/// A remark on that, for users; empty where the boundary does not cross itself.
[[nodiscard]] std::string remark_on_closure(const Barrier& barrier);

/// The area that B(q) encloses: from sums along the manifolds. Where it crosses itself, that of what it winds round, as
/// Boundary::area; where it runs round a cylinder, the area between it and the line along the lattice through the
/// origin, negative below that.
[[nodiscard]] Measured enclosed_area(const Barrier& barrier);

/// int w v, w and v the winding numbers of two closed polygons through points of smooth curves.
struct WindingProduct {
  double area = 0, error = 0;
  double length = 0;  ///< length of both polygons where they can matter
  /// Where both may lie so far from the true curves, see Barrier.
  [[nodiscard]] Measured with(double curve_error) const { return {area, error + curve_error * length}; }
};
[[nodiscard]] WindingProduct product_of_windings(const std::vector<Point>& first, const std::vector<Point>& second);

}  // namespace lober::detail
