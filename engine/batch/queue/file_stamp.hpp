// A file as it is now, told from what it was before without reading it.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace lober::detail {

/// Equal stamps at two times: the file has not been written, replaced or renamed between them. Writing through a
/// shared mapping shows when the system writes the pages down.
struct FileStamp {
  std::uint64_t device = 0, number = 0, size = 0;  ///< number: the inode
  std::int64_t modified = 0, changed = 0;          ///< nanoseconds since 1970: content; content, name or rights
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// The stamp of a file that was last changed at least `age` ago; none for one that is younger, which could be changed
/// once more within a tick of the clock of its file system, and for one that cannot be opened. Opens the file, as
/// network file systems ask the server then and not before. Some microseconds.
[[nodiscard]] std::optional<FileStamp> file_stamp(const std::string& path, std::chrono::nanoseconds age);

}  // namespace lober::detail
