// Bytes in memory under the name of a file, for libraries that take nothing but names.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lober::detail {

class MemoryFile {
 public:
  /// Throws DataError "name: ..." where the system gives none.
  MemoryFile(const std::string& name, std::span<const std::byte> bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace lober::detail
