// The arrays of a tangle, whoever made it (private to engine/c).
#pragma once

#include <memory>

#include "engine/c/result.hpp"

namespace lober::detail::c {

/// All that lober.h lists for lober_tangle; the result keeps the tangle, for outlines.
void add_tangle(lober_result& result, std::shared_ptr<const Tangle> tangle, bool smooth);

}  // namespace lober::detail::c
