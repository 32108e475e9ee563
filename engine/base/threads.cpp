#include "lober/threads.hpp"

#include "engine/base/parallel/parallel.hpp"

namespace lober {
using namespace detail;

void run_with_threads(int threads, const std::function<void()>& function) {
  with_threads(threads, function);
}

}  // namespace lober
