// The local manifolds of one map as far as those of maps nearby begin from them (private to engine/).
//
// They move smoothly with a parameter: those of the next value are extrapolated and corrected. Whether pips can be
// followed as well is another question, and where they cannot, the manifolds of that value are known all the same.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "lober/dynamics/local_manifold.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail {

/// Values of a parameter that an extrapolation uses, the last one included.
inline constexpr std::size_t values_to_extrapolate = 3;
/// A value of the past that is nearer than this part of a step tells little about that step.
inline constexpr double shortest_past = 0.25;

/// Whether a value at this offset from one that is known is far enough from that one, and from the one `step` from it,
/// to be used with them: values may come back to where they were.
[[nodiscard]] bool lies_apart(double offset, double step);

/// The weights with which values at `offsets` add up to that at `at` of the polynomial through them.
[[nodiscard]] std::vector<double> interpolation_weights(std::span<const double> offsets, double at);

/// A local manifold, and those of the values before it as far as they have the same reach.
struct KnownManifold {
  struct Past {
    double offset;  ///< in the parameter, from here to there
    Point saddle;
    double multiplier;
    std::vector<Point> coefficients;
  };
  LocalManifold local;
  std::vector<Past> past;  ///< the nearest first
  /// A part of it that has more of a past, where the reach has become larger.
  std::shared_ptr<const KnownManifold> part;
  /// Steps since it was last tried in vain to make it longer, and how many there are to be until it is tried again.
  int waited = 0, wait = 0;

  /// About the manifold at this offset of the parameter, by the polynomial through those that are known.
  [[nodiscard]] LocalManifold at(double offset) const;
};

struct KnownManifolds {
  KnownManifold u, s;
};

/// The manifolds of the map whose parameter is `step` from that of `from`. Throws as local_manifold.
[[nodiscard]] KnownManifolds continued_manifolds(const PlanarMap& map, const Connection& connection,
                                                 const KnownManifolds& from, double step);

/// Whether enough of the past is known for manifolds_between.
[[nodiscard]] bool are_known_between(const KnownManifolds& to);
/// About the manifolds `step` from those that were continued, a little before them: near enough to tell on the way
/// there which pip is which.
[[nodiscard]] KnownManifolds manifolds_between(const KnownManifolds& to, double step);

}  // namespace lober::detail
