// The colours of the program's pictures, so that pages have the same.
#pragma once

#if __has_include("cli/picture/palette.hpp")
#include "cli/picture/palette.hpp"
#else
#include "cli/report/palette.hpp"
#endif

namespace lober::viewer {
namespace palette = cli::palette;
}
