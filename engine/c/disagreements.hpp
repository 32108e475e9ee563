// Routes that differ by more than their bars, for C (private to engine/c).
#pragma once

#include <string>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/lober.h"

namespace lober::detail::c {

/// One text, a line each.
[[nodiscard]] std::string lines_of(const std::vector<std::string>& lines);

/// Adds them to the result, and throws, where routes disagree.
void require_agreement(lober_result& result, const Agreement& agreement);

}  // namespace lober::detail::c
