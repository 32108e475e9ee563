// The value at which the two sides of a turnstile change places, between two values of a sweep (private to engine/).
#pragma once

#include <functional>

#include "engine/dynamics/transport/sweep/sweep_value.hpp"

namespace lober::detail {

/// The zero of the difference between two rows with differences of opposite signs. Values in between are continued from
/// the turnstiles of their neighbours; at the zero itself `row_at` grows a tangle from nothing, and where that says
/// otherwise all values in between are found by it.
[[nodiscard]] SweepZero refined_zero(const Family& family, const SweepValue& first, const SweepValue& last,
                                     double zero_tolerance, const std::function<SweepValue(double)>& row_at);

}  // namespace lober::detail
