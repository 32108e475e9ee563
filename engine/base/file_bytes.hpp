// The bytes of a file, whatever kind of file it is.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "lober/base/buffer.hpp"

namespace lober::detail {

/// The content of a file in memory. A regular file is read in parallel, and is refused when it changes meanwhile: a
/// file that is mapped instead would kill the process if another one truncated it. A file without a size (a pipe, a
/// terminal, a process substitution) is read to its end, but no further than a quarter of the machine's memory; other
/// devices have no end and are refused. The path "-" is standard input. Throws DataError "path: reason".
class FileBytes {
 public:
  explicit FileBytes(const std::string& path);
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return buffer_; }

 private:
  Buffer<std::byte> buffer_;
};

}  // namespace lober::detail
