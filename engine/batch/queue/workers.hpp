// Tasks that may start further ones, on the threads of the present arena (private to engine/batch). They ask what the
// thread that starts them asks whether they are cancelled.
#pragma once

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <utility>

#include "engine/base/parallel/handover.hpp"
#include "engine/base/parallel/inherited_cancellation.hpp"

namespace lober::detail {

class WorkerTasks {
 public:
  template <typename Task>
  void start(Task task) {
    started_.release();
    group_.run([this, task = std::move(task), scope = CancellationScope::current()]() LOBER_UNSEEN {
      started_.acquire();
      const Ended ended{ended_};
      const InheritedCancellation inherited(scope);
      task();
    });
  }
  /// Passes on what a task threw.
  void wait() {
    const Waited waited{ended_};
    group_.wait();
  }

 private:
  struct Ended {
    HandOver& at;
    ~Ended() { at.release(); }
  };
  struct Waited {
    HandOver& at;
    ~Waited() { at.acquire(); }
  };
  HandOver started_, ended_;
  tbb::task_group group_;
};

/// A thread that waits inside `function` does nothing but work that it started.
template <typename Function>
void isolated(const Function& function) {
  tbb::this_task_arena::isolate(function);
}

}  // namespace lober::detail
