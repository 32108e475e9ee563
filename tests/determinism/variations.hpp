// The same computation with other numbers of threads, indexes and instruction sets.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/geometry/index/index.hpp"
#include "kernels/cpu.hpp"

namespace lober::detail {

struct Variation {
  InstructionSet isa;
  int threads;
  IndexKind index;
};
[[nodiscard]] std::string text(const Variation& variation);

/// The first one is what others are compared with: one thread, the tree, the best copies that the processor has. By
/// default each number of threads (1, 2, 7), index and instruction set occurs once or twice; all combinations when the
/// environment variable LOBER_ALL_VARIATIONS is set. `indexes`: whether the index matters.
[[nodiscard]] std::vector<Variation> variations(bool indexes);

/// Fails the test unless `hash` gives the same for all variations; its own threads and instruction set are set, the
/// index is handed to it.
void expect_same(bool indexes, const std::function<std::uint64_t(IndexKind)>& hash);

}  // namespace lober::detail
