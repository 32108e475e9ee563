// No output of a command replaces one of its inputs, however either of them is named.
#pragma once

#include <sys/stat.h>

#include <string>

namespace lober::detail {

/// While one lives, every file that the process reads (curves, manifests, plug-ins, stores) is remembered, and an
/// OutputFile refuses to replace it: the same path, another spelling of it, a symbolic or a hard link. Without one,
/// as in a program that uses the library, nothing is remembered and files may be rewritten in place. Guards may be
/// nested; the last one to go forgets. Any thread may read and write meanwhile.
class InputGuard {
 public:
  InputGuard();
  ~InputGuard();
  InputGuard(const InputGuard&) = delete;
  InputGuard& operator=(const InputGuard&) = delete;
};

/// Remembers a file that is read, if a guard lives: what `status` identifies, and what `path` leads to ("-" is standard
/// input, which has no path). Paths that are not regular files are not remembered: writing to them replaces nothing.
/// O(log n).
void note_input(const std::string& path, const struct ::stat& status);
/// The same for a file that somebody else opens. Does nothing if it is not there.
void note_input(const std::string& path);

/// Whether `status`, or `path`, is one of the files remembered.
[[nodiscard]] bool is_noted_input(const std::string& path, const struct ::stat& status);

}  // namespace lober::detail
