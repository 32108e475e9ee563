// The files that a run has written, and what to do with them next: lines on standard error in the end, for people at a
// terminal.
#pragma once

#include <cstddef>
#include <string>

namespace lober::cli {

/// The file may be written, as the option says; check_outputs calls this for all outputs. Not for "-" and devices.
void expect_written(const std::string& option, const std::string& path);
/// It holds that number of curves with that number of points in all, which is said instead of its size.
void note_curves_written(const std::string& path, std::size_t curves, std::size_t points);

/// "wrote tangle.svg (120 kB); open it in a web browser": a line for each expected file that is not as it was when it
/// was expected, of many the first.
[[nodiscard]] std::string written_files_text();

}  // namespace lober::cli
