#include "engine/dynamics/transport/tangles/area_preservation.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/text.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

void require_areas_preserved(const PlanarMap& map, Point saddle) {
  Matrix2 a;
  map.iterate_with_derivative(saddle, 1, a);
  const double largest = std::max({std::fabs(a.xx), std::fabs(a.xy), std::fabs(a.yx), std::fabs(a.yy)});
  const double factor = std::fabs(a.xx * a.yy - a.xy * a.yx);
  if (std::fabs(factor - 1) <= 1e-3 + 1e-10 * largest * largest) return;
  throw DataError("transport: the map does not preserve area, it multiplies it by " + format_number(factor) +
                  " at the saddle " + format_point(saddle) + "; lober tangle lists its lobes");
}

}  // namespace lober::detail
