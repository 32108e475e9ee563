// The synchronisation of oneTBB that ThreadSanitizer cannot see (private to the engine).
//
// oneTBB as distributions ship it is not instrumented: ThreadSanitizer does not know that a task starts after it was
// spawned and that its end comes before what waits for it goes on, and would take every such hand-over for a race. So
// the few places that give work to oneTBB say it. In other builds all of this is empty. The code of
// oneTBB's headers is left out of what is instrumented (cmake/tsan-ignore.txt).
#pragma once

#include "engine/base/parallel/sanitizers.hpp"

#if LOBER_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
/// For a function that oneTBB calls: what it reads before its Part is made was written in time all the same.
#define LOBER_UNSEEN __attribute__((no_sanitize("thread")))
#else
#define LOBER_UNSEEN
#endif

namespace lober::detail {

/// Whatever happened before a `release` happens before what follows an `acquire` that comes later in time.
class HandOver {
 public:
#if LOBER_THREAD_SANITIZER
  void release() {
    __tsan_release(&at_);
  }
  void acquire() {
    __tsan_acquire(&at_);
  }

 private:
  char at_ = 0;
#else
  void release() {}
  void acquire() {}
#endif
};

/// Work that begins after this is made and ends before it goes: each part of it runs within a Part of its own.
class HandedOver {
 public:
  HandedOver() { begins_.release(); }
  ~HandedOver() { ends_.acquire(); }
  HandedOver(const HandedOver&) = delete;
  HandedOver& operator=(const HandedOver&) = delete;

  class Part {
   public:
    explicit Part(HandedOver& whole) : whole_(whole) { whole_.begins_.acquire(); }
    ~Part() { whole_.ends_.release(); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    HandedOver& whole_;
  };

 private:
  HandOver begins_, ends_;
};

}  // namespace lober::detail
