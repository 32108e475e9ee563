// The fields of the result of an escape (private to operations/).
#pragma once

#include <vector>

#include "lober/operations.hpp"

namespace lober::detail::table {

[[nodiscard]] std::vector<operations::Field> escape_fields();

}  // namespace lober::detail::table
