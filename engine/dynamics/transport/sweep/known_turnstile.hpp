// The turnstile of one map as far as those of maps nearby begin from it (private to engine/).
//
// Local manifolds and the orbits of the pips move smoothly with a parameter. From those of a value nearby Newton's
// method finds them in a few steps; no manifold is grown.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/dynamics/transport/tangles/tangle_growth.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail {

/// The change of a local manifold by a parameter, per unit of it; empty where it is not known.
struct ManifoldRate {
  Point saddle;
  double multiplier = 0;
  std::vector<Point> coefficients;
};

struct KnownTurnstile {
  LocalManifold u, s;
  ManifoldRate rate_u, rate_s;
  std::vector<ConnectingOrbit> orbits;  ///< orbits of the pips of one iterate, from f^-1(q) to q

  /// Pips come and go in pairs; one that was there before is lost, and its orbit without meaning.
  [[nodiscard]] bool is_lost(std::size_t number) const { return std::isinf(orbits[number].residual); }

  /// W(q) - W(q') as in SweepRow::difference; nothing without an action, or when a pip is lost.
  [[nodiscard]] std::optional<double> difference() const;
  /// Estimate of the error of the difference.
  [[nodiscard]] double error() const;
  /// The image of pip `number` whose tangle takes the least growing.
  [[nodiscard]] KnownBip bip(std::size_t number) const;
  /// The number of the pip, 1 for the one after f^-1(q) to the last for q, whose orbit, or an image of it, is pip
  /// `number` of another turnstile of the same map; nothing if none is.
  [[nodiscard]] std::optional<std::size_t> same_pip(const KnownTurnstile& other, std::size_t number) const;
};

[[nodiscard]] KnownTurnstile known_turnstile(const ManifoldTangle& found);

/// The turnstile of the map whose parameter is `step` from that of `from`, with the same pips; as q the image in the
/// middle between the saddles. Nothing where q is not found, or not behind the others. Throws as local_manifold.
[[nodiscard]] std::optional<KnownTurnstile> continued_turnstile(const PlanarMap& map, const Connection& connection,
                                                                const KnownTurnstile& from, double step);

}  // namespace lober::detail
