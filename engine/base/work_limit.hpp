// Work that ends at a limit of its own (private to the engine).
#pragma once

#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

/// Runs the function, whose progress is to say no once `spent()` holds. False if it was broken off for that. Throws
/// what it throws, Cancelled for other reasons.
template <typename Function, typename Spent>
[[nodiscard]] bool completes(const Function& function, const Spent& spent) {
  try {
    function();
  } catch (const Cancelled&) {
    if (!spent() || is_cancelled()) throw;
    return false;
  }
  return true;
}

}  // namespace lober::detail
