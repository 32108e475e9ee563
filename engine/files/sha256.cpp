#include <fcntl.h>
#include <nettle/base16.h>
#include <nettle/sha2.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>
#include <vector>

#include "engine/base/input_guard.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober {
using namespace detail;
namespace {

class Sha256 {
 public:
  Sha256() { sha256_init(&context_); }
  void add(std::span<const std::byte> bytes) {
    sha256_update(&context_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  }
  [[nodiscard]] std::string hexadecimal() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&context_, digest.size(), digest.data());
    std::string text(BASE16_ENCODE_LENGTH(digest.size()), '0');
    base16_encode_update(text.data(), digest.size(), digest.data());
    return text;
  }

 private:
  sha256_ctx context_;
};

// A file to be read once, from its beginning to its end.
class HashedFile {
 public:
  explicit HashedFile(const std::string& path) : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) fail();
    before_ = status();
    note_input(path, before_);
  }
  ~HashedFile() { ::close(descriptor_); }
  HashedFile(const HashedFile&) = delete;
  HashedFile& operator=(const HashedFile&) = delete;

  // The number of bytes read; 0 at the end.
  std::size_t read(std::span<std::byte> into) const {
    ::ssize_t got = 0;
    do {
      got = ::read(descriptor_, into.data(), into.size());
    } while (got < 0 && errno == EINTR);
    if (got < 0) fail();
    return static_cast<std::size_t>(got);
  }

  void require_unchanged() const {
    const struct stat after = status();
    if (after.st_size != before_.st_size || after.st_mtim.tv_sec != before_.st_mtim.tv_sec ||
        after.st_mtim.tv_nsec != before_.st_mtim.tv_nsec) {
      throw DataError(path_ + ": was changed while it was read");
    }
  }

 private:
  [[noreturn]] void fail() const {
    const int code = errno;
    throw DataError(path_ + ": " + std::generic_category().message(code));
  }
  [[nodiscard]] struct stat status() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail();
    return status;
  }

  const std::string& path_;
  int descriptor_;
  struct stat before_ {};
};

}  // namespace

std::string sha256(std::span<const std::byte> bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hexadecimal();
}

std::string sha256_of_file(const std::string& path) {
  const HashedFile file(path);
  Sha256 hash;
  std::vector<std::byte> piece(std::size_t{1} << 20);
  for (std::size_t got = file.read(piece); got != 0; got = file.read(piece)) hash.add(std::span(piece).first(got));
  file.require_unchanged();
  return hash.hexadecimal();
}

}  // namespace lober
