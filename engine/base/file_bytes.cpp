#include "engine/base/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "engine/base/file_activity.hpp"
#include "engine/base/input_guard.hpp"
#include "engine/base/machine_memory.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/path_text.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t piece_bytes = std::size_t{4} << 20;  // bytes of one call, and of one thread

[[noreturn]] void fail(const std::string& path) {
  const int code = errno;
  throw DataError(path + ": " + std::generic_category().message(code));
}

/// Closes what it opened; standard input is borrowed.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_((require_no_zero_byte(path), path == "-") ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (number_ < 0) fail(path);
  }
  ~Descriptor() {
    if (number_ != STDIN_FILENO) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

struct stat status_of(const Descriptor& file, const std::string& path) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(path);
  return status;
}

/// Fills the span from an offset of the file on; fewer bytes only where the file ends. `read(bytes, size, from)` is as
/// pread.
template <typename Read>
std::size_t filled(std::span<std::byte> bytes, const std::string& path, const Read& read) {
  std::size_t used = 0;
  while (used < bytes.size()) {
    const ::ssize_t got = read(bytes.data() + used, bytes.size() - used, used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  return used;
}

void read_regular(const Descriptor& file, const struct stat& before, const std::string& path,
                  Buffer<std::byte>& buffer) {
  buffer.resize(static_cast<std::size_t>(before.st_size));
  note_size_to_read(buffer.size());
  for_each_block(buffer.size(), piece_bytes, [&](std::size_t begin, std::size_t end) {
    const std::size_t got = filled(std::span(buffer).subspan(begin, end - begin), path,
                                   [&](std::byte* to, std::size_t size, std::size_t from) {
                                     return ::pread(file.number(), to, size, static_cast<::off_t>(begin + from));
                                   });
    note_read(got);
    if (got != end - begin) throw DataError(path + ": was truncated while it was read");
  });
  const struct stat after = status_of(file, path);
  if (after.st_size != before.st_size || after.st_mtim.tv_sec != before.st_mtim.tv_sec ||
      after.st_mtim.tv_nsec != before.st_mtim.tv_nsec) {
    throw DataError(path + ": was changed while it was read");
  }
}

void read_to_end(const Descriptor& file, const std::string& path, Buffer<std::byte>& buffer) {
  const std::size_t most = memory_for_unknown_content();
  std::size_t used = 0;
  for (;;) {
    if (used == buffer.size()) {
      if (used > most) {
        throw DataError(path + ": goes on after " + std::to_string(used >> 20) +
                        " MiB, without a size that could be known; write it to a file first");
      }
      Buffer<std::byte> larger(used == 0 ? std::size_t{1} << 16 : 2 * used);
      if (used != 0) std::memcpy(larger.data(), buffer.data(), used);
      buffer = std::move(larger);
    }
    const ::ssize_t got = ::read(file.number(), buffer.data() + used, std::min(piece_bytes, buffer.size() - used));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    note_read(static_cast<std::uint64_t>(got));
  }
  buffer.resize(used);
}

}  // namespace

FileBytes::FileBytes(const std::string& path) {
  const Descriptor file(path);
  const struct stat status = status_of(file, path);
  if (S_ISDIR(status.st_mode)) throw DataError(path + ": is a directory");
  note_input(path, status);
  if (S_ISBLK(status.st_mode) || (S_ISCHR(status.st_mode) && ::isatty(file.number()) == 0)) {
    throw DataError(path + ": is a device, not a file");
  }
  // A regular file of size zero may still have content: those under /proc do. Standard input may be a regular
  // file of which somebody has already read a part.
  if (S_ISREG(status.st_mode) && status.st_size > 0 && path != "-") {
    read_regular(file, status, path, buffer_);
  } else {
    read_to_end(file, path, buffer_);
  }
}

}  // namespace lober::detail
