// How a benchmark ends.
#pragma once

#include <exception>
#include <iostream>
#include <stdexcept>

namespace lober::bench {

/// The exit status of `run()`; an exception becomes a line "NAME: reason" and status 2 for a wrong argument
/// (std::invalid_argument), else 1.
template <typename Run>
int exit_status(const char* name, const Run& run) {
  try {
    return run();
  } catch (const std::invalid_argument& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
}

}  // namespace lober::bench
