// The bytes of a file, whatever kind of file it is.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lober {

/// A regular file is memory-mapped; a pipe, a terminal or a process substitution is read to its end. The path
/// "-" is standard input. Throws DataError "path: reason".
class MappedFile {
 public:
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

 private:
  void read_to_end(int descriptor, const std::string& path);

  void* mapping_ = nullptr;
  std::vector<std::byte> buffer_;  ///< holds the bytes when there is no mapping
  std::span<const std::byte> bytes_;
};

}  // namespace lober
