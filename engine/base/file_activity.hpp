// The file that the process reads or writes at this moment, for those who show progress.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lober::detail {

/// The state of the file that was opened last.
struct FileActivity {
  std::string path;
  bool is_written = false;
  double bytes = 0;          ///< written; or read, where those count half that are not parsed yet
  std::uint64_t number = 0;  ///< counts the files that were opened
  double fraction = 0;       ///< read so far of a file, from 0 to 1; 0 where its size is not known
};

/// As long as it lives the file counts as being read or written. Where several files are open at a time, as in batches,
/// what is shown is one of them. Costs a mutex; the functions below cost an atomic addition each.
class FileActivityScope {
 public:
  FileActivityScope(const std::string& path, bool is_written);
  ~FileActivityScope();
  FileActivityScope(const FileActivityScope&) = delete;
  FileActivityScope& operator=(const FileActivityScope&) = delete;
};

/// The size of the file that is read, in bytes, has become known.
void note_size_to_read(std::uint64_t bytes);
/// Bytes have come from the file; from any thread.
void note_read(std::uint64_t bytes);
/// A part of the `all` bytes that the file has, unpacked, has been parsed.
void note_parsed(std::uint64_t bytes, std::uint64_t all);
void note_written(std::uint64_t bytes);

/// Nothing where no file is read or written.
[[nodiscard]] std::optional<FileActivity> file_activity();

}  // namespace lober::detail
