// An operation of the table without a command of its own: `lober NAME INPUTS [options]`, with its options, its numbers
// as text and its JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lober/operations.hpp"

namespace lober::cli {

/// "fixed-points" of fixed_points.
[[nodiscard]] std::string command_name(const operations::Operation& operation);
/// The operation of that command name; null if there is none.
[[nodiscard]] const operations::Operation* operation_called(std::string_view word);

/// Runs it. Throws as the operation and as commands do.
void run_operation(const operations::Operation& operation, const std::vector<std::string>& arguments);

/// "lober regions C1 C2 [options]".
[[nodiscard]] std::string call_of(const operations::Operation& operation);

}  // namespace lober::cli
