// The system that an operation is about (private to operations/).
#pragma once

#include <span>

#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

/// The first input.
[[nodiscard]] const SystemInput& system_input_of(std::span<const Input> inputs);
/// Throws UsageError unless it has a planar map.
[[nodiscard]] const SystemInput& system_of(std::span<const Input> inputs);

}  // namespace lober::detail::table
