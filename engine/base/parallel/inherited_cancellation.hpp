// The cancellation of pieces of parallel work by the flags of the thread that began it (private to the engine).
#pragma once

#include "lober/base/cancellation.hpp"

namespace lober::detail {

[[noreturn]] void throw_cancelled();

/// A piece of parallel work asks what the thread that began the work asks.
class InheritedCancellation {
 public:
  explicit InheritedCancellation(const CancellationScope* scope) noexcept;
  ~InheritedCancellation();
  InheritedCancellation(const InheritedCancellation&) = delete;
  InheritedCancellation& operator=(const InheritedCancellation&) = delete;

 private:
  const CancellationScope* before_;
};

}  // namespace lober::detail
