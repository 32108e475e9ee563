// The number of threads that may be asked for.
#pragma once

namespace lober::detail {

/// Throws UsageError unless `threads` is 0 (one for each core) to max_threads (lober/threads.hpp).
void require_thread_count(int threads);

}  // namespace lober::detail
