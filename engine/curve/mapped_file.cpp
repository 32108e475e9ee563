#include "engine/curve/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "engine/curve/input_guard.hpp"
#include "engine/error.hpp"

namespace lober {
namespace {

[[noreturn]] void fail(const std::string& path) {
  const int code = errno;
  throw DataError(path + ": " + std::generic_category().message(code));
}

/// Closes what it opened; standard input is borrowed.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
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

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  const Descriptor file(path);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(path);
  if (S_ISDIR(status.st_mode)) throw DataError(path + ": is a directory");
  note_input(path, status);
  // A regular file of size zero may still have content: those under /proc do. Standard input may be a regular
  // file of which somebody has already read a part.
  if (S_ISREG(status.st_mode) && status.st_size > 0 && path != "-") {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number(), 0);
    if (mapping != MAP_FAILED) {
      mapping_ = mapping;
      bytes_ = {static_cast<const std::byte*>(mapping), size};
      return;
    }
  }
  read_to_end(file.number(), path);
}

MappedFile::~MappedFile() {
  if (mapping_ != nullptr) ::munmap(mapping_, bytes_.size());
}

void MappedFile::read_to_end(int descriptor, const std::string& path) {
  constexpr std::size_t first_size = std::size_t{1} << 16;
  std::size_t used = 0;
  for (;;) {
    if (used == buffer_.size()) buffer_.resize(used == 0 ? first_size : 2 * used);
    const ::ssize_t got = ::read(descriptor, buffer_.data() + used, buffer_.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  bytes_ = {buffer_.data(), used};
}

}  // namespace lober
