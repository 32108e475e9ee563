// One value of a sweep, and how others are reached from it (private to engine/).
#pragma once

#include <optional>

#include "engine/dynamics/transport/sweep/known_manifolds.hpp"
#include "engine/dynamics/transport/sweep/known_turnstile.hpp"
#include "lober/transport/sweep.hpp"

namespace lober::detail {

/// A row of a sweep, and its turnstile if it has one.
struct SweepValue {
  SweepRow row;
  std::optional<KnownTurnstile> known;
};

/// The turnstile of a value from that of one nearby, which is `step` before it; nothing where it is not found, or the
/// family has no such member. Throws Cancelled.
[[nodiscard]] std::optional<KnownTurnstile> continued_to(const Family& family, double value, const KnownTurnstile& from,
                                                         double step);

/// A value that is reached from another one: its manifolds, and its turnstile where the pips can be followed.
struct Followed {
  std::optional<KnownManifolds> manifolds;
  std::optional<KnownTurnstile> turnstile;
};

/// The manifolds and the turnstile of a value from those of another one, in smaller steps where one is too large.
/// Throws Cancelled.
[[nodiscard]] Followed followed_to(const Family& family, double value, double from_value, const KnownTurnstile& from);

}  // namespace lober::detail
