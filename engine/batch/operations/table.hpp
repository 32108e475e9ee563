// The makers of the operations in the table (private to operations/).
#pragma once

#include "engine/batch/operations/operation.hpp"

namespace lober::detail {

[[nodiscard]] Operation overlay_operation();
[[nodiscard]] Operation escape_operation();
[[nodiscard]] Operation fixed_points_operation();
[[nodiscard]] Operation grow_operation();
[[nodiscard]] Operation interior_operation();
[[nodiscard]] Operation levels_operation();
[[nodiscard]] Operation curve_transport_operation();
[[nodiscard]] Operation densify_operation();
[[nodiscard]] Operation manifold_tangle_operation();
[[nodiscard]] Operation regions_operation();
[[nodiscard]] Operation section_operation();
[[nodiscard]] Operation simplify_operation();
[[nodiscard]] Operation sweep_operation();
[[nodiscard]] Operation tangle_operation();
[[nodiscard]] Operation transport_operation();
[[nodiscard]] Operation winding_operation();

}  // namespace lober::detail
