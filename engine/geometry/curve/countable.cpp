#include "engine/geometry/curve/countable.hpp"

#include <string>

#include "lober/base/error.hpp"

namespace lober::detail {

void require_countable(std::size_t count, std::string_view what) {
  if (count <= max_count) return;
  throw DataError(std::to_string(count) + " " + std::string(what) + ", the limit is " + std::to_string(max_count));
}

}  // namespace lober::detail
