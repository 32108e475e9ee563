// Fields of results for a tangle that was grown (private to operations/).
#pragma once

#include "engine/operations/schema.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail::table {
using namespace operations;

/// Both saddles with their manifolds.
[[nodiscard]] const Schema<ManifoldTangle>& saddles_schema();
/// The lobes from f^-1(q) to q, and the pips that they end in: fields for others to go on with.
[[nodiscard]] Schema<ManifoldTangle> turnstile_schema();

}  // namespace lober::detail::table
