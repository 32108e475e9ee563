#include "engine/batch/queue/file_stamp.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lober::detail {
namespace {

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

}  // namespace

std::optional<FileStamp> file_stamp(const std::string& path, std::chrono::nanoseconds age) {
  // Without waiting: opening a pipe would, until somebody writes.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return std::nullopt;
  struct stat status {};
  const bool known = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  ::close(file);
  if (!known) return std::nullopt;
  const FileStamp stamp{status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
                        nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  // Anybody may set the time of modification; that of the last change is the system's.
  if (nanoseconds(now) - stamp.changed < age.count()) return std::nullopt;
  return stamp;
}

}  // namespace lober::detail
