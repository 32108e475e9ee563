// The progress function of a thread that calls C (private to engine/c).
#pragma once

#include <atomic>
#include <functional>

namespace lober::detail::c {

/// The callback of this thread, for operations whose progress is a fraction and, with -1, for others; empty if the
/// thread has none. It may be called by any thread.
[[nodiscard]] std::function<bool(double)> progress();

/// Throws UsageError within a progress function: one that calls an operation, which calls it, would never end.
void refuse_in_progress_function();

/// Runs work that tells no progress itself, while another thread calls the progress function ten times a second, with
/// the fraction that `done` has. Where it cancels, work ends with Cancelled as soon as it asks (cancellation.hpp).
void run_watched(const std::atomic<double>& done, const std::function<void()>& work);

}  // namespace lober::detail::c
