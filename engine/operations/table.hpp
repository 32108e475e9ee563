// The operations of the table, by name (private to operations/). A new one is a file beside this one, which defines
// NAME_operation(), and its name in this list.
#pragma once

#include "lober/operations.hpp"

// clang-format off
#define LOBER_OPERATIONS(X)                                                                                     \
  X(curve_transport) X(densify) X(escape) X(fixed_points) X(grow) X(image) X(interior) X(levels)                \
  X(manifold_tangle) X(overlay) X(regions) X(section) X(simplify) X(sweep) X(tangle) X(transport) X(winding)
// clang-format on

namespace lober::detail::table {
using namespace operations;

#define LOBER_DECLARE(name) [[nodiscard]] Operation name##_operation();
LOBER_OPERATIONS(LOBER_DECLARE)
#undef LOBER_DECLARE

}  // namespace lober::detail::table
