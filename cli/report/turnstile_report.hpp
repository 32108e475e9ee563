// Common parts of reports on manifolds grown from equations: their saddles and the lobes of the turnstile.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lober/tangle/manifold_tangle.hpp"

namespace lober::cli {

/// A lobe of the turnstile.
struct TurnstileLobe {
  std::size_t number = 0;
  double area = 0;          ///< signed, by geometry
  double error = 0;         ///< estimate for it
  double action = 0;        ///< signed, by action; NaN without one
  double action_error = 0;  ///< estimate for it
  double difference = 0;    ///< | area - action |
};
[[nodiscard]] std::vector<TurnstileLobe> turnstile_lobes(const ManifoldTangle& manifolds);

/// A few lines: saddles and multipliers of both manifolds.
[[nodiscard]] std::string saddles_text(const ManifoldTangle& manifolds);
/// A line each for the lobes of the turnstile: by geometry, by action, difference.
[[nodiscard]] std::string turnstile_text(const ManifoldTangle& manifolds);

}  // namespace lober::cli
