// The system that an operation is about, and its progress (private to operations/).
#pragma once

#include <functional>
#include <span>
#include <string>

#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

/// The first input.
[[nodiscard]] const SystemInput& system_input_of(std::span<const Input> inputs);
/// Throws UsageError unless it has a planar map.
[[nodiscard]] const SystemInput& system_of(std::span<const Input> inputs);

/// For options whose progress takes a line; empty where nobody listens.
[[nodiscard]] std::function<bool(const std::string&)> lines_to(const Context& context);

}  // namespace lober::detail::table
