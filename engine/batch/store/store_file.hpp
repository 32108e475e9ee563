// The file that a store is: whether it may be one, and whether it still is where it was (private to engine/batch).
#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "engine/batch/store/database.hpp"

namespace lober::detail {

/// Knows a file by device and inode, so that it is noticed when it is deleted, moved or replaced while it is open.
class StoreFile {
 public:
  /// Before the file is opened. Throws UsageError for a name that is not one of a file (":memory:", an empty one),
  /// DataError for a file that is not there, or whose folder is not there if it is to be `written`, and for what can
  /// hold no store: a device, a pipe, a file that is too short to be a database and not empty,
  /// and, to be `written`, a file with several names: SQLite keeps its log beside one of them, and who opens the file
  /// by another one damages it.
  StoreFile(std::string path, bool written);
  ~StoreFile();
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  /// Hard links of the file: its log may lie beside another one.
  [[nodiscard]] bool has_several_names() const { return several_names_; }
  /// When the file is there: notes which one it is.
  void opened();
  /// Throws DataError when the name no longer leads to that file. The contents of the database are saved before: into
  /// the file if it only has another name now, into a new one beside the old place if it was deleted. The message says
  /// where. Not inside a transaction.
  void require_in_place(Database& database) const;

 private:
  void require_that_it_can_be(bool made) const;
  [[nodiscard]] bool in_place() const;
  [[nodiscard]] std::string present_name() const;

  std::string path_;
  ::dev_t device_ = 0;
  ::ino_t inode_ = 0;
  bool several_names_ = false;
  int handle_ = -1;  ///< refers to the file without opening it: closing it gives up no lock of this process
};

/// Throws UsageError when two of the paths lead to one file, by links of whatever kind.
void require_different_stores(std::span<const std::string> paths);

}  // namespace lober::detail
