// Time of a phase.
#pragma once

#include <chrono>
#include <utility>

namespace lober::detail {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// The same, and starts anew: phases that follow each other take one look at the clock each.
  [[nodiscard]] double lap() {
    const auto now = std::chrono::steady_clock::now(), start = std::exchange(start_, now);
    return std::chrono::duration<double>(now - start).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace lober::detail
