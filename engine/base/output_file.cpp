#include "engine/base/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "engine/base/input_guard.hpp"
#include "engine/base/path_text.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

/// The descriptor of this process that a path stands for. Opening /dev/stdout anew would truncate a file that
/// the shell redirected to, and write over what is already there.
std::optional<int> own_descriptor(std::string_view path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    int number = 0;
    const char* const end = path.data() + path.size();
    const auto [stop, error] = std::from_chars(path.data() + folder.size(), end, number);
    if (stop == end && error == std::errc{}) return number;
  }
  return std::nullopt;
}

/// Retries what a signal interrupted.
template <typename Call>
auto uninterrupted(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  require_no_zero_byte(path_);
  struct ::stat status {};
  if (const auto own = own_descriptor(path_)) {
    // Text that the program printed earlier has to come first.
    if (*own == STDOUT_FILENO) std::fflush(stdout);
    descriptor_ = ::fcntl(*own, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail();
    if (::fstat(descriptor_, &status) == 0) require_no_input(status);
    return;
  }
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists) require_no_input(status);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = uninterrupted([&] { return ::open(path_.c_str(), O_WRONLY | O_CLOEXEC); });
    if (descriptor_ < 0) fail();
    return;
  }
  if (exists) {
    std::error_code error;
    const auto resolved = std::filesystem::canonical(path_, error);
    if (!error) target_ = resolved.string();
    // A file that may not be written must not be replaced either.
    if (::access(target_.c_str(), W_OK) != 0) fail();
  }
  open_beside();
  // Fails on file systems without modes, where there is nothing to keep either.
  if (exists) static_cast<void>(::fchmod(descriptor_, status.st_mode & 07777));
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::require_no_input(const struct ::stat& status) {
  if (!is_noted_input(path_, status)) return;
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  throw UsageError(path_ + ": would overwrite an input of the same command");
}

void OutputFile::open_beside() {
  static std::atomic<unsigned> counter = 0;
  do {
    temporary_ = target_ + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    descriptor_ =
        uninterrupted([&] { return ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail();
}

void OutputFile::write(std::string_view content) {
  if (!activity_) activity_.emplace(path_, true);
  while (!content.empty()) {
    const ::ssize_t written = uninterrupted([&] { return ::write(descriptor_, content.data(), content.size()); });
    if (written < 0) fail();
    note_written(static_cast<std::uint64_t>(written));
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  // Some file systems report a failed write only here.
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
  activity_.reset();
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail();
  temporary_.clear();
}

void OutputFile::fail() const {
  const int code = errno;
  throw DataError(path_ + ": cannot be written: " + std::generic_category().message(code));
}

}  // namespace lober::detail
