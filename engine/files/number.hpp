// One number of a text file.
#pragma once

#include <cstdint>
#include <string_view>

namespace lober::detail {

enum class NumberKind : std::uint8_t {
  finite,
  not_a_number,  ///< not a literal at all
  not_finite,    ///< nan, inf, or too large for a double
};

/// Reads the whole of `token`: an optional sign, digits with an optional point, an optional exponent after e,
/// E, d or D (Fortran). The value is the double nearest to the literal, ties to even, as strtod gives in the
/// C locale; too small a literal becomes a zero of its sign.
[[nodiscard]] NumberKind parse_number(std::string_view token, double& value);

}  // namespace lober::detail
