// The sources of pages, as CMake found them in viewer/page: each script is its modules in one.
#pragma once

#include <string_view>

namespace lober::viewer {

extern const std::string_view page_html, page_style, page_script, batch_html, batch_script;

}  // namespace lober::viewer
