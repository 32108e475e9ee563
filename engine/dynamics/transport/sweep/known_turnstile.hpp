// The turnstile of one map as far as those of maps nearby begin from it (private to engine/).
//
// Local manifolds and the orbits of the pips move smoothly with a parameter. From those of a value nearby Newton's
// method finds them in a few steps; no manifold is grown.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/dynamics/transport/sweep/known_manifolds.hpp"
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail {

/// Where the pips were on one manifold of a value before.
struct PastPositions {
  double log_factor;  ///< logarithm of the factor of an image there
  std::vector<ManifoldPosition> at;
};

struct KnownTurnstile {
  struct Past {
    double offset;  ///< in the parameter, from here to there
    PastPositions u, s;
  };
  KnownManifolds on;
  std::vector<ConnectingOrbit> orbits;  ///< orbits of the pips of one iterate, from f^-1(q) to q
  /// Whether S crosses U from right to left there, for the orbits that were continued; or empty.
  std::vector<char> to_left;
  std::vector<Past> past;  ///< where the images of these pips were, the nearest value first

  /// Pips come and go in pairs; one that was there before is lost, and its orbit without meaning.
  [[nodiscard]] bool is_lost(std::size_t number) const { return std::isinf(orbits[number].residual); }

  /// W(q) - W(q') as in SweepRow::difference; nothing without an action, or when a pip is lost.
  [[nodiscard]] std::optional<double> difference() const;
  /// Estimate of the error of the difference.
  [[nodiscard]] double error() const;
  /// The manifolds, and the image of pip `number` whose tangle takes the least growing.
  [[nodiscard]] KnownStart start(std::size_t number) const;
  /// The number of the pip, 1 for the one after f^-1(q) to the last for q, whose orbit, or an image of it, is pip
  /// `number` of another turnstile of the same map; nothing if none is.
  [[nodiscard]] std::optional<std::size_t> same_pip(const KnownTurnstile& other, std::size_t number) const;
};

[[nodiscard]] KnownTurnstile known_turnstile(const ManifoldTangle& found);

/// The turnstile of the map whose parameter is `step` from that of `from`, and whose manifolds are known, with the same
/// pips; as q the image in the middle between the saddles. Nothing where q is not found, or not behind the others, or
/// where a pip may be another one.
[[nodiscard]] std::optional<KnownTurnstile> continued_turnstile(const PlanarMap& map, KnownManifolds manifolds,
                                                                const KnownTurnstile& from, double step);

}  // namespace lober::detail
