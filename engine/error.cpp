#include "engine/error.hpp"

#include <array>
#include <charconv>
#include <string>

namespace lober {
namespace {

std::string shortest(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string describe(int curve, std::uint32_t first, std::uint32_t second, Point place) {
  return "curve " + std::to_string(curve) + " is not simple: segments " + std::to_string(first) + " and " +
         std::to_string(second) + " meet at (" + shortest(place.x) + ", " + shortest(place.y) + ")";
}

}  // namespace

NotSimpleError::NotSimpleError(int curve_number, std::uint32_t first, std::uint32_t second, Point place)
    : DataError(describe(curve_number, first, second, place)),
      curve(curve_number),
      segment1(first),
      segment2(second),
      at(place) {}

}  // namespace lober
