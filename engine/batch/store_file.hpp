// The file that a store is: whether it may be one, and whether it still is where it was (private to jobs/).
#pragma once

#include <sys/types.h>

#include <string>

#include "engine/batch/database.hpp"

namespace lober::detail {

/// Knows a file by device and inode, so that it is noticed when it is deleted, moved or replaced while it is open.
class StoreFile {
 public:
  /// Before the file is opened. Throws UsageError for a name that is not one of a file (":memory:", an empty one),
  /// DataError for what can hold no store: a device, a pipe, or a file that is too short to be a database and not
  /// empty.
  explicit StoreFile(std::string path);
  ~StoreFile();
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  /// When the file is there: notes which one it is.
  void opened();
  /// Throws DataError when the name no longer leads to that file. What the database holds is saved before: into the
  /// file if it only has another name now, into a new one beside the old place if it was deleted. The message says
  /// where. Not inside a transaction.
  void require_in_place(Database& database) const;

 private:
  [[nodiscard]] bool in_place() const;
  [[nodiscard]] std::string present_name() const;

  std::string path_;
  ::dev_t device_ = 0;
  ::ino_t inode_ = 0;
  int handle_ = -1;  ///< refers to the file without opening it: closing it gives up no lock of this process
};

}  // namespace lober::detail
