// The check for simple curves at another scale than the caller's, with its counts (private to engine/).
#pragma once

#include "lober/overlay/crossings.hpp"

namespace lober::detail {

/// Like require_simple, for a curve whose coordinates are the caller's times 2^exponent; errors give points in the
/// caller's own.
SimpleCheck require_simple_scaled(const IndexedCurve& curve, int number, int exponent);

}  // namespace lober::detail
