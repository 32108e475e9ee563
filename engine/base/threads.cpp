#include "lober/base/threads.hpp"

#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/thread_limit.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;

void detail::require_thread_count(int threads) {
  if (threads >= 0 && threads <= max_threads) return;
  throw UsageError("threads has to be 0 (one for each core) to " + std::to_string(max_threads) + ", not " +
                   std::to_string(threads));
}

void run_with_threads(int threads, const std::function<void()>& function) {
  require_thread_count(threads);
  with_threads(threads, function);
}

}  // namespace lober
