// Periods as a person writes them.
#pragma once

#include <string_view>

#include "lober/curve/periods.hpp"

namespace lober::detail {

/// Takes "x=1", "y=360", "x=2pi" or "x=pi" into `periods`. False, and nothing taken, where the text is something else
/// or the period is not positive and finite.
[[nodiscard]] bool take_period(std::string_view text, Periods& periods);

}  // namespace lober::detail
