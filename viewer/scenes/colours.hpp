// The colours of the program's pictures, so that pages have the same.
#pragma once

#include "cli/picture/palette.hpp"

namespace lober::viewer {
namespace palette = cli::palette;
}
