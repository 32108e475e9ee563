// The interrupt from the keyboard.
#pragma once

#include <atomic>

namespace lober::cli {

/// From now on the first interrupt sets interrupt_flag() and is answered at once by a line on standard error; a second
/// one ends the program with exit status 130.
void watch_for_interrupt();
/// Set by the first interrupt; for CancellationScope.
[[nodiscard]] const std::atomic<bool>& interrupt_flag();
[[nodiscard]] bool interrupted();

}  // namespace lober::cli
