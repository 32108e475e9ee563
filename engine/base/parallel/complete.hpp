// Whether oneTBB ran all pieces of a loop (private to parallel/).
#pragma once

#include <tbb/task_group.h>

#include "engine/base/parallel/inherited_cancellation.hpp"

namespace lober::detail {

/// An exception in a loop around this one makes oneTBB leave out the pieces that have not begun, here too, and return
/// as if nothing were missing. Missing parts must not be used.
inline void require_complete(tbb::task_group_context& context) {
  if (context.is_group_execution_cancelled()) throw_cancelled();
}

}  // namespace lober::detail
