// Transport across the boundary of a tangle: what leaves a region, iterate by iterate.
//
// R1 is the region inside the boundary B(q), R2 the rest. L12(1) is what the map takes from R1 to R2 in one step,
// L21(1) the way back: the lobes of the turnstile. Of two fluids, one in each region at the start, the flux a(n) is the
// area that enters R1 in step n and comes from R2, equal to the area that leaves R1 and was there from the start, and
// T(n) the total. With mu the area and f the map (Rom-Kedar & Wiggins 1990; DESIGN section 2),
//
//   lobe method       a(n) = mu(L21(1)) - sum over m < n of mu(L12(1) n f^m(L21(1))),    T(n) = a(1) + ... + a(n),
//   boundary method   T(n) = area(R1 \ f^n(R1)) = area(f^n(R1) \ R1) = area(R1) - area(R1 n f^n(R1)),
//
// for maps that preserve area. Both come from one pair of manifolds. By area preservation f may be applied to both
// sides of an intersection as often as one likes, so that no lobe is followed for longer than half of n.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/transport/manifold_tangle.hpp"

namespace lober {

struct TransportOptions {
  int iterates = 7;
  double tolerance = 1e-5;          ///< of the manifolds, see ManifoldTangleOptions
  std::optional<Point> bip_near{};  ///< of q
  std::size_t most_points = 20'000'000;
  std::function<bool(const std::string&)> progress{};
};

struct TransportStep {
  int n = 0;
  double flux = 0;     ///< a12(n) = a21(n), by lobes
  double total = 0;    ///< T12(n) = T21(n), by lobes
  double overlap = 0;  ///< mu(L12(1) n f^(n-1)(L21(1)))
  /// T(n) = area of R1 less that of R1 n f^n(R1). NaN, with its error and the consistency, where the chord that closes
  /// R1 meets the manifolds: the region is then bounded by more than the chord, and this cannot know by what.
  double by_boundaries = 0;
  double boundary_error = 0;  ///< estimated error of that
  double consistency = 0;     ///< |total - by_boundaries|
  /// Estimated error of T(n): what the smooth curves may be wrong by, summed over the lobes that enter.
  double discretisation = 0;
};

struct Transport {
  std::unique_ptr<ManifoldTangle> manifolds;
  double region = 0;                  ///< area of R1
  double area12 = 0, area21 = 0;      ///< mu(L12(1)), mu(L21(1)), by geometry; equal but for errors
  double action12 = 0, action21 = 0;  ///< the same by action; NaN without one
  std::vector<TransportStep> steps;   ///< n = 1, 2, ...
};

/// Everything from a map: grows the manifolds, finds the turnstile and computes a(n) and T(n) for n up to
/// options.iterates. Lobes of the turnstile that overlap each other count with their difference. Throws as grow_tangle,
/// and DataError where the map does not preserve area.
[[nodiscard]] Transport transport(const PlanarMap& map, const Connection& connection,
                                  const TransportOptions& options = {});

}  // namespace lober
