#include "engine/base/parallel/inherited_cancellation.hpp"

#include <utility>

#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

thread_local const CancellationScope* innermost = nullptr;

}  // namespace

CancellationScope::CancellationScope(const std::atomic<bool>& flag) noexcept
    : flag_(&flag), around_(std::exchange(innermost, this)) {}
CancellationScope::CancellationScope(Shield) noexcept : flag_(nullptr), around_(std::exchange(innermost, this)) {}
CancellationScope::~CancellationScope() {
  innermost = around_;
}

const CancellationScope* CancellationScope::current() noexcept {
  return innermost;
}

bool CancellationScope::cancelled() const noexcept {
  for (const CancellationScope* scope = this; scope != nullptr && scope->flag_ != nullptr; scope = scope->around_) {
    if (scope->flag_->load(std::memory_order_relaxed)) return true;
  }
  return false;
}

bool is_cancelled() noexcept {
  return innermost != nullptr && innermost->cancelled();
}

void throw_if_cancelled() {
  if (is_cancelled()) throw_cancelled();
}

void detail::throw_cancelled() {
  throw Cancelled();
}

InheritedCancellation::InheritedCancellation(const CancellationScope* scope) noexcept
    : before_(std::exchange(innermost, scope)) {}
InheritedCancellation::~InheritedCancellation() {
  innermost = before_;
}

}  // namespace lober
