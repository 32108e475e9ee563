// Melnikov's function of a system, beside what its tangle has (private to operations/).
#pragma once

#include "engine/operations/schema.hpp"
#include "lober/transport/melnikov.hpp"

namespace lober::detail::table {
using namespace operations;

/// The parameter that is the size of the system's perturbation. Throws UsageError for one that is not a flow with such
/// a parameter.
[[nodiscard]] const Parameter& perturbation_of(const System& system);

/// Melnikov's function of a system with such a parameter, with `values` of others. Throws as `perturbation_of` and
/// `melnikov` do.
[[nodiscard]] Melnikov melnikov_of(const SystemInput& input, const ParameterValues& values, const System& system,
                                   const Connection& connection);

/// The function with sums of the lobes of the turnstile, by action where the map has one.
[[nodiscard]] MelnikovComparison melnikov_comparison(Melnikov function, const System& system,
                                                     const ManifoldTangle& manifolds);

[[nodiscard]] const Schema<MelnikovComparison>& melnikov_schema();

}  // namespace lober::detail::table
