// The location of an error in a file, and its one form in messages.
#pragma once

#include <cstddef>
#include <string>

#include "lober/base/error.hpp"

namespace lober::detail {

/// A line of a text file, counted from 1.
struct SourceLocation {
  const std::string& path;
  std::size_t line;

  [[noreturn]] void fail(const std::string& message) const {
    throw DataError(path + ":" + std::to_string(line) + ": " + message);
  }
};

}  // namespace lober::detail
