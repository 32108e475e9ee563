#include "lober/base/error.hpp"

#include <string>

#include "engine/base/text.hpp"

namespace lober {
using namespace detail;
namespace {

std::string describe(int curve, std::uint32_t first, std::uint32_t second, Point point) {
  return "curve " + std::to_string(curve) + " is not simple: segments " + std::to_string(first) + " and " +
         std::to_string(second) + " meet at " + format_point(point);
}

}  // namespace

NotSimpleError::NotSimpleError(int curve_number, std::uint32_t first, std::uint32_t second, Point point)
    : DataError(describe(curve_number, first, second, point)),
      curve(curve_number),
      segment1(first),
      segment2(second),
      at(point) {}

}  // namespace lober
