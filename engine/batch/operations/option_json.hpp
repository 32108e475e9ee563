// Values of options in nlohmann's JSON (private to the batch).
#pragma once

#include "engine/batch/operations/options.hpp"

namespace lober::detail {

/// Points, rectangles and lists as arrays of numbers.
template <typename Json>
Json json_of(const OptionValue& value) {
  if (const auto* const flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* const real = std::get_if<double>(&value)) return *real;
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return operations::numbers_of(value);
}

}  // namespace lober::detail
