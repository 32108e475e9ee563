// Coordinates of a state are numbered by int in the public interface, and arrays by std::size_t.
#pragma once

#include <cstddef>

namespace lober::detail {

[[nodiscard]] constexpr std::size_t state_index(int coordinate) {
  return static_cast<std::size_t>(coordinate);
}

}  // namespace lober::detail
