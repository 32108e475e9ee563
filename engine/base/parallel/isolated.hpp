// Loops within loops.
#pragma once

#include "engine/base/parallel/function_ref.hpp"

namespace lober::detail {

/// Runs `function`; a thread that waits inside does nothing but work that it started there. Without, it might begin
/// another piece of the loop around, and wait in that again, and so on, as deep as there are pieces.
void run_isolated(FunctionRef<void()> function);

}  // namespace lober::detail
