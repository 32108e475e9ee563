#include "engine/geometry/curve/require.hpp"

#include <string>

namespace lober::detail {

void require_closed(CurveView curve, std::string_view name, std::string_view operation) {
  if (!curve.closed)
    throw UsageError(std::string(name) + " is open; " + std::string(operation) + " needs closed curves");
}

void require_open(CurveView curve, std::string_view name, std::string_view operation) {
  if (curve.closed)
    throw UsageError(std::string(name) + " is closed; " + std::string(operation) + " needs open curves");
}

void require_region(CurveView curve, std::string_view name, std::string_view operation) {
  require_closed(curve, name, operation);
  require_enough_vertices(curve, name);
}

}  // namespace lober::detail
