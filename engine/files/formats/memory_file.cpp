#include "engine/files/formats/memory_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "lober/base/error.hpp"

namespace lober::detail {

MemoryFile::MemoryFile(const std::string& name, std::span<const std::byte> bytes)
    : descriptor_(::memfd_create("lober", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {
  const auto fail = [&] {
    const int code = errno;
    if (descriptor_ >= 0) ::close(descriptor_);
    throw DataError(name + ": " + std::generic_category().message(code));
  };
  if (descriptor_ < 0) fail();
  while (!bytes.empty()) {
    const ::ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

MemoryFile::~MemoryFile() {
  ::close(descriptor_);
}

}  // namespace lober::detail
