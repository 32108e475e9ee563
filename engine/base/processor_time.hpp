// Processor time, which other processes of the machine do not lengthen.
#pragma once

#include <ctime>

namespace lober::detail {

/// Seconds that the calling thread has had a core.
[[nodiscard]] inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace lober::detail
