// Values of options in nlohmann's JSON (private to the batch).
#pragma once

#include "engine/batch/operations/options.hpp"

namespace lober::detail {

/// Points as arrays of two numbers.
template <typename Json>
Json json_of(const OptionValue& value) {
  if (const auto* const point = std::get_if<Point>(&value)) return Json::array({point->x, point->y});
  return std::visit(
      [](const auto& any) {
        if constexpr (std::is_same_v<std::decay_t<decltype(any)>, Point>) {
          return Json();
        } else {
          return Json(any);
        }
      },
      value);
}

}  // namespace lober::detail
