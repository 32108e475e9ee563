// Numbers that whoever runs the tests may set.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace lober {

/// The unsigned number in an environment variable, or `otherwise` when no variable has that name.
inline std::uint64_t from_environment(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace lober
