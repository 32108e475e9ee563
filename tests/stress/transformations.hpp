// Transformations of a pair of curves that keep their areas, or change them in a known way, and others that change them
// by rounding only.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "tests/oracle/families.hpp"

namespace lober::stress {

/// A pair after a transformation.
struct Transformed {
  oracle::CurvePair pair;
  bool exact = false;  ///< every area is that of the pair before, times 4^exponent, and so is that of every piece
  int exponent = 0;
};

struct Transformation {
  std::string_view name;
  Transformed (*apply)(const oracle::CurvePair& pair, oracle::Random& random);
};

/// All of them; the first one changes nothing. Those that round may make a curve that is not simple.
[[nodiscard]] std::span<const Transformation> transformations();

/// Draws from the seed of the pair and the name of the transformation.
[[nodiscard]] Transformed transformed(const oracle::CurvePair& pair, const Transformation& transformation);

}  // namespace lober::stress
