// The memory of the machine.
#pragma once

#include <unistd.h>

#include <cstddef>

namespace lober::detail {

/// In bytes.
[[nodiscard]] inline std::size_t machine_memory() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGE_SIZE));
}

/// The most that is taken for content whose size nobody knows before: what a pipe or a compressed file gives, or what a
/// few bytes promise.
[[nodiscard]] inline std::size_t memory_for_unknown_content() {
  return machine_memory() / 4;
}

}  // namespace lober::detail
