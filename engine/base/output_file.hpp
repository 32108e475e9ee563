// A file that appears under its name only when it is complete.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>
#include <string_view>

#include "engine/base/file_activity.hpp"

namespace lober::detail {

/// Writes beside the file and renames in `commit`; an uncommitted file is removed and leaves an existing one as it was.
/// A symbolic link keeps pointing where it does: its target is replaced. A path that is not a regular file (a pipe, a
/// device, /dev/stdout and its like, "-" for standard output) is written straight through. Every member throws
/// DataError "path: reason"; the constructor throws UsageError for a file that the process has read while an InputGuard
/// lives (input_guard.hpp).
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view content);
  void commit();
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void require_no_input(const struct ::stat& status);
  void open_beside();
  [[noreturn]] void fail() const;

  std::string path_;       ///< as the caller named it, for messages
  std::string target_;     ///< the file that is replaced
  std::string temporary_;  ///< empty when written straight through, and after `commit`
  int descriptor_ = -1;
  std::optional<FileActivityScope> activity_;  ///< once something is written, until `commit`
};

}  // namespace lober::detail
