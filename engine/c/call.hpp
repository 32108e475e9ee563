// Conversions from C to C++ and back: exceptions become numbers and a message, pointers become curves (private to
// engine/c).
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine/c/options.hpp"
#include "engine/c/progress.hpp"
#include "engine/c/result.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail::c {

/// Runs the function; the status that its exception stands for, whose text is then that of lober_message(). Refuses
/// within a progress function.
[[nodiscard]] int guarded(const std::function<void()>& function) noexcept;

/// An operation: options are asked for by `prepare`, which returns the work; that fills the result with as many threads
/// as asked for. *result is null unless there is one.
[[nodiscard]] int operation(const char* options, lober_result** result,
                            const std::function<std::function<void(lober_result&)>(Options&)>& prepare) noexcept;

/// Thrown by an operation to hand out its result with a status that is not LOBER_OK.
struct WithResult {
  int status;
  std::string text;
};

/// Throws UsageError for a null pointer.
[[nodiscard]] std::span<const Point> points_of(const double* points, std::size_t count, const char* name);
/// The points of the caller as a curve, checked.
[[nodiscard]] ClosedCurve closed_curve(const double* points, std::size_t count, const char* name);

}  // namespace lober::detail::c
