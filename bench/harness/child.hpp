// The benchmark starting itself again: a rival may crash, run out of memory or never end, and peak memory can
// be measured only in a process that has done nothing else.
#pragma once

#include <string>
#include <string_view>

#include "bench/harness/options.hpp"
#include "bench/rivals/rival.hpp"

namespace lober::bench {

/// The rival on a scene, in a process of its own. `note` says why, when it did not finish.
[[nodiscard]] RivalResult run_rival_apart(const Rival& rival, const SceneKind& scene, std::size_t points, double limit);

/// Peak memory of the overlay beyond the curves, in bytes per point of both curves together, on one thread.
[[nodiscard]] double memory_per_point(const SceneKind& scene, std::size_t points);

/// The work of the process started by one of the two; returns its exit status.
int run_as_child(const Options& options);

}  // namespace lober::bench
