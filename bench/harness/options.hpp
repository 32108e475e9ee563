// The options of the benchmark.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/rivals/rival.hpp"
#include "bench/scenes/scenes.hpp"
#include "engine/geometry/index/index.hpp"

namespace lober::bench {
using namespace lober::detail;

enum class RivalChoice { none, fast, all };

struct Options {
  std::size_t points = 1'000'000;     ///< per curve, for the main table
  std::size_t small_points = 10'000;  ///< per curve, for the rivals that cannot do more
  std::vector<const SceneKind*> scenes;
  std::vector<int> threads{1, 2};
  IndexKind index = IndexKind::automatic;  ///< of our own engine
  int repeat = 5;                          ///< at least; jobs under 50 ms are repeated for a second
  RivalChoice rivals = RivalChoice::fast;
  double limit = 60;  ///< seconds for a rival and a scene
  bool growth = true;
  std::string markdown;  ///< file for the tables besides standard output
  /// Set in the processes that the benchmark starts for itself: "memory" or the name of a rival.
  std::string child;
};

/// Throws std::invalid_argument with one line to print; prints the usage and returns false for --help.
[[nodiscard]] bool parse_options(int count, char** arguments, Options& options);

}  // namespace lober::bench
