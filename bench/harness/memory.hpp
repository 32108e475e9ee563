// Peak memory.
#pragma once

#include <cstddef>

#include "bench/scenes/scenes.hpp"

namespace lober::bench {

/// Bytes that one overlay (one thread, all pieces) needs at its peak beyond what the process held before, per
/// point of both curves. To be called in a fresh process, once. Linux only; throws std::runtime_error
/// elsewhere.
[[nodiscard]] double measure_memory(const SceneKind& kind, std::size_t points);

}  // namespace lober::bench
