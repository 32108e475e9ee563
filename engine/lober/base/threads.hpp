// The number of threads that work.
#pragma once

#include <functional>

#include "lober/base/export.hpp"

namespace lober {

/// The most threads that may be asked for: operating systems refuse more, or give them no stack.
inline constexpr int max_threads = 4096;

/// Runs the function with at most `threads` threads, also more than the machine has cores; 0: one for each core.
/// Results are the same bits for any number. Throws UsageError for less than 0 or more than max_threads; passes on what
/// the function throws. Loops that it begins ask the CancellationScope of the caller.
LOBER_API void run_with_threads(int threads, const std::function<void()>& function);

}  // namespace lober
