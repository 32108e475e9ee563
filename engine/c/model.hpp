// The contents of a lober_model (private to engine/c).
#pragma once

#include "lober/lober.h"
#include "lober/operations.hpp"

struct lober_model {
  lober::operations::SystemInput input;
  [[nodiscard]] const lober::System& system() const { return *input.system; }
};

namespace lober::detail::c {

/// Throws UsageError for a null pointer, DataError for a system without a map.
[[nodiscard]] const PlanarMap& map_of(const lober_model* model);

}  // namespace lober::detail::c
