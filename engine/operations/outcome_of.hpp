// The outcome of an operation from its value (private to operations/).
#pragma once

#include <memory>
#include <utility>

#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

/// The outcome of a value; of its agreement and its remarks, where it has some.
template <typename T>
Outcome outcome_of(T value, const Options& options) {
  Outcome outcome;
  if constexpr (requires { value.agreement; }) outcome.agreement = value.agreement;
  if constexpr (requires { value.remarks; }) outcome.remarks = value.remarks;
  outcome.options = options;
  outcome.value = std::make_shared<const T>(std::move(value));
  return outcome;
}

}  // namespace lober::detail::table
