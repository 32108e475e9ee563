#include "engine/batch/store/store_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <map>
#include <utility>

namespace lober::detail {
namespace {

constexpr ::off_t shortest_database = 512;  // one page

// A copy under a name that is not taken yet: all that is committed, in one file.
std::string saved_beside(const std::string& path, Database& database) {
  std::string name = path + ".rescued";
  for (int k = 2; std::filesystem::exists(name); ++k) name = path + ".rescued-" + std::to_string(k);
  Statement(database, "VACUUM INTO ?1").bind(1, std::string_view(name)).run();
  return name;
}

}  // namespace

StoreFile::StoreFile(std::string path, bool written) : path_(std::move(path)) {
  // SQLite takes these for databases that go with the process.
  if (path_.empty()) throw UsageError("the name of the store is empty");
  if (path_ == ":memory:") throw UsageError(":memory: keeps no results; name a file for the store");
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0) {
    require_that_it_can_be(written);
    return;
  }
  if (!S_ISREG(status.st_mode)) throw DataError(path_ + ": is not a file; name a file for the store");
  if (status.st_size > 0 && status.st_size < shortest_database) throw DataError(path_ + ": is not a store of results");
  several_names_ = status.st_nlink > 1;
  if (!written || !several_names_) return;
  throw DataError(path_ + ": has " + std::to_string(status.st_nlink) +
                  " names (hard links), but a store can have only one; copy the file, or remove the other names");
}

// SQLite says of both that it cannot open the file.
void StoreFile::require_that_it_can_be(bool made) const {
  if (errno != ENOENT && errno != ENOTDIR) return;
  if (!made) throw DataError(path_ + ": No such file or directory; a store is written by lober batch run");
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  std::error_code ignored;
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return;
  throw DataError(path_ + ": needs the folder " + folder.string() + ", which does not exist; make it first");
}

StoreFile::~StoreFile() {
  if (handle_ >= 0) ::close(handle_);
}

void StoreFile::opened() {
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0) throw DataError(path_ + ": vanished while it was opened");
  device_ = status.st_dev;
  inode_ = status.st_ino;
#ifdef O_PATH
  handle_ = ::open(path_.c_str(), O_PATH | O_CLOEXEC);
#endif
}

bool StoreFile::in_place() const {
  struct stat status {};
  return ::stat(path_.c_str(), &status) == 0 && status.st_dev == device_ && status.st_ino == inode_ &&
         status.st_nlink > 0;
}

// Where the file is now; empty if it has no name any more, or none that can be found out.
std::string StoreFile::present_name() const {
  struct stat status {};
  if (handle_ < 0 || ::fstat(handle_, &status) != 0 || status.st_nlink == 0) return {};
  std::array<char, 4096> name{};
  const ::ssize_t length =
      ::readlink(("/proc/self/fd/" + std::to_string(handle_)).c_str(), name.data(), name.size() - 1);
  if (length <= 0) return {};
  std::string found(name.data(), static_cast<std::size_t>(length));
  struct stat there {};
  const bool right = ::stat(found.c_str(), &there) == 0 && there.st_dev == device_ && there.st_ino == inode_;
  return right ? found : std::string();
}

void StoreFile::require_in_place(Database& database) const {
  if (in_place()) return;
  std::string where;
  try {
    if (const std::string name = present_name(); !name.empty()) {
      database.execute("PRAGMA wal_checkpoint(TRUNCATE)");  // the log has stayed behind
      where = "is now " + name + ", which has all results so far";
    } else {
      where = "was deleted; its results so far are saved in " + saved_beside(path_, database);
    }
  } catch (const Error& error) {
    where = std::string("was deleted or moved, and its results so far could not be saved (") + error.what() + ")";
  }
  throw DataError(path_ + ": the store is not there any more: it " + where);
}

void require_different_stores(std::span<const std::string> paths) {
  std::map<std::pair<::dev_t, ::ino_t>, std::string> known;
  for (const std::string& path : paths) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) continue;
    const auto [at, is_new] = known.try_emplace({status.st_dev, status.st_ino}, path);
    if (!is_new) throw UsageError(at->second + " and " + path + " are the same store; name each store once");
  }
}

}  // namespace lober::detail
