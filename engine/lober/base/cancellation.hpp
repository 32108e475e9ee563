// Cancellation of long work from outside: by another thread or by the handler of a signal.
//
// A caller opens a CancellationScope with a flag. From then on all work of its thread checks the flag; so do the pieces
// of the parallel loops that it begins, and of the loops that those begin (parallel.hpp passes the scope on). Once the
// flag is set they throw Cancelled. So a function need not carry the flag through its arguments; a loop that neither
// starts parallel pieces nor integrates, and may take longer than a tenth of a second, calls throw_if_cancelled()
// itself.
//
//   std::atomic<bool> flag{false};
//   const lober::CancellationScope scope(flag);
//   const lober::Overlay result = lober::overlay(first, second);  // throws Cancelled soon after flag = true
//
// The convention for callbacks of all functions of the library: `progress` is called by one thread at a time, which
// need not be the calling one, several times a second; false cancels. Then the function throws Cancelled, except where
// its result says why it ended (`stop`) and holds what was done. An exception of a callback stops the work and reaches
// the caller. Functions that the library evaluates (CurveFunction, PlanarMap, Flow, Family) are called by many threads
// at a time and have to return the same for the same argument. A callback may call the library.
#pragma once

#include <atomic>

#include "lober/base/export.hpp"

namespace lober {

/// While it lives, the work of this thread can be cancelled by the flag, and by the flags of the scopes around it.
/// A scope lives on the stack of one thread; the flag must outlive it. Scopes of one thread end in the reverse order in
/// which they began.
class CancellationScope {
 public:
  /// The work of this thread is cancelled when the flag is set.
  LOBER_API explicit CancellationScope(const std::atomic<bool>& flag) noexcept;
  /// Within it nothing is cancelled: for storing the results from before a cancellation.
  struct Shield {};
  /// Begins a scope in which nothing is cancelled.
  LOBER_API explicit CancellationScope(Shield) noexcept;
  /// Ends the scope.
  LOBER_API ~CancellationScope();
  CancellationScope(const CancellationScope&) = delete;
  CancellationScope& operator=(const CancellationScope&) = delete;

  /// The innermost scope of this thread; null if there is none.
  [[nodiscard]] LOBER_API static const CancellationScope* current() noexcept;
  /// Whether the flag of this scope, or of one around it, is set.
  [[nodiscard]] LOBER_API bool cancelled() const noexcept;

 private:
  const std::atomic<bool>* flag_;  ///< null: a shield
  const CancellationScope* around_;
};

/// Whether a flag of this thread's scopes is set. A few nanoseconds.
[[nodiscard]] LOBER_API bool is_cancelled() noexcept;
/// Throws Cancelled when a flag of this thread's scopes is set.
LOBER_API void throw_if_cancelled();

}  // namespace lober
