// A file that appears under its name only when it is complete.
#pragma once

#include <string>
#include <string_view>

namespace lober {

/// Writes beside the file and renames in `commit`; what is not committed is removed and leaves an existing
/// file as it was. A symbolic link keeps pointing where it does: its target is replaced. What is no regular
/// file (a pipe, a device, /dev/stdout and its like, "-" for standard output) is written straight through.
/// Every member throws DataError "path: reason".
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view content);
  void commit();

 private:
  void open_beside();
  [[noreturn]] void fail() const;

  std::string path_;       ///< as the caller named it, for messages
  std::string target_;     ///< what is replaced
  std::string temporary_;  ///< empty when written straight through, and after `commit`
  int descriptor_ = -1;
};

}  // namespace lober
