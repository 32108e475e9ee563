// SVG as PDF and PNG, by librsvg and cairo where they are installed: loaded when the first such picture is written.
#pragma once

#include <string>
#include <string_view>

namespace lober::cli {

/// Why pictures cannot be converted, and what to do, as the end of a message; empty where they can.
[[nodiscard]] std::string reason_no_conversion();

/// The picture in the size that it has in print. Throws DataError where a library is missing or fails.
[[nodiscard]] std::string pdf_of(const std::string& svg);
/// With this number of pixels an inch.
[[nodiscard]] std::string png_of(const std::string& svg, double resolution);

}  // namespace lober::cli
