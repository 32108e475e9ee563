// The interrupt from the keyboard.
#pragma once

namespace lober::cli {

/// From now on the first interrupt is only noted; a second one kills.
void watch_for_interrupt();
[[nodiscard]] bool interrupted();

}  // namespace lober::cli
