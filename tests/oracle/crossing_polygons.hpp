// Random pairs of closed polygons that cross, touch and overlap themselves and each other.
#pragma once

#include <array>
#include <ostream>
#include <string_view>

#include "tests/oracle/shapes.hpp"

namespace lober::oracle {

struct CrossingFamily {
  std::string_view name;
  PolygonPair (*make)(Random& random);
};

/// For the names of tests.
inline std::ostream& operator<<(std::ostream& stream, const CrossingFamily& family) {
  return stream << family.name;
}

/// Every polygon has at least three distinct vertices, and few enough for an oracle of cubic cost.
[[nodiscard]] const std::array<CrossingFamily, 16>& crossing_families();

}  // namespace lober::oracle
