// The number of threads that work.
#pragma once

#include <functional>

#include "lober/export.hpp"

namespace lober {

/// Runs the function with at most `threads` threads, also more than the machine has cores; 0: one for each core.
/// Results are the same bits for any number. Passes on what the function throws. Loops that it begins ask the
/// CancellationScope of the caller.
LOBER_API void run_with_threads(int threads, const std::function<void()>& function);

}  // namespace lober
