// A test of the engine on this machine, by areas that are known exactly.
#pragma once

#include <cstddef>
#include <string>

namespace lober::cli {

struct SelfTest {
  std::size_t points = 0, crossings = 0, pieces = 0;  ///< found, of both curves
  double seconds = 0;
  std::string failure;  ///< what differs; empty where all is as it has to be
};

/// Two combs whose teeth cross: the areas, crossings and pieces are whole numbers, and have to be met to the last bit
/// by the overlay and by the interior method, with one thread and with all. Well below a second.
[[nodiscard]] SelfTest run_self_test();

}  // namespace lober::cli
