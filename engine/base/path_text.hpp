// Names of files that the operating system can be asked for.
#pragma once

#include <string>

#include "lober/base/error.hpp"

namespace lober::detail {

/// A name with a zero byte would be cut there, and another file read or replaced. Throws DataError.
inline void require_no_zero_byte(const std::string& path) {
  const std::size_t zero = path.find('\0');
  if (zero == std::string::npos) return;
  throw DataError("the name of a file has a zero byte after \"" + path.substr(0, zero) + "\"; leave it out");
}

}  // namespace lober::detail
