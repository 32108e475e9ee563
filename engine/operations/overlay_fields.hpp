// What the result of an overlay consists of (private to operations/).
#pragma once

#include <vector>

#include "lober/operations.hpp"

namespace lober::detail::table {

[[nodiscard]] std::vector<operations::Field> overlay_fields();

}  // namespace lober::detail::table
