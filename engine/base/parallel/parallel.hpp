// The one place where threads come from: a thin cover of oneTBB, which only its source files include.
//
// Nothing in the engine may depend on the number of threads, so work is cut into pieces of a size that the *data*
// decides, never the machine, and whatever a piece produces is joined in the order of the pieces.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/base/parallel/function_ref.hpp"
#include "lober/base/cancellation.hpp"

namespace lober::detail {

/// Calls body(begin, end) for [0, size) cut into pieces of exactly `grain` (the last one may be shorter), in
/// parallel when there is more than one. Throws Cancelled between pieces (cancellation.hpp), and what a piece throws.
void for_each_block(std::size_t size, std::size_t grain, FunctionRef<void(std::size_t, std::size_t)> body);

void run_side_by_side(std::span<const FunctionRef<void()>> functions);
void run_in_arena(int threads, FunctionRef<void()> function);

/// Runs the functions side by side when `parallel`, one after the other when not. They ask what the caller asks
/// whether they are cancelled.
template <typename... Functions>
void parallel_if(bool parallel, Functions&&... functions) {
  if (parallel) {
    const std::array<FunctionRef<void()>, sizeof...(Functions)> all{FunctionRef<void()>(functions)...};
    run_side_by_side(all);
  } else {
    (functions(), ...);
  }
}

/// The number of threads that the loops of the calling thread have.
[[nodiscard]] int concurrency();

/// Runs `function` with at most `threads` threads, also more than the machine has cores (0: one for each), and returns
/// what it returns.
template <typename Function>
auto with_threads(int threads, Function&& function) {
  if (threads <= 0) return function();
  if constexpr (std::is_void_v<decltype(function())>) {
    run_in_arena(threads, function);
  } else {
    std::optional<decltype(function())> result;
    run_in_arena(threads, [&] { result.emplace(function()); });
    return std::move(*result);
  }
}

}  // namespace lober::detail
