#include "engine/files/formats/optional_library.hpp"

#include <dlfcn.h>

#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Loaded once and never unloaded: some leave threads and handlers behind. The system counts, so asking again is quick.
void* handle_of(std::string_view file) {
  return file.empty() ? nullptr : dlopen(std::string(file).c_str(), RTLD_NOW | RTLD_LOCAL);
}

}  // namespace

bool OptionalLibrary::is_present() const {
  return handle_of(file_) != nullptr;
}

std::string OptionalLibrary::reason_it_is_missing() const {
  if (!is_built_in()) {
    return "this lober was built without the package " + std::string(headers_) + "; build it where that is installed";
  }
  if (!is_present()) return std::string(file_) + " is not installed; install the package " + std::string(package_);
  return {};
}

void* OptionalLibrary::symbol(const char* name) const {
  void* const handle = handle_of(file_);
  if (handle == nullptr) throw DataError(reason_it_is_missing());
  void* const found = dlsym(handle, name);
  if (found == nullptr) throw DataError(std::string(file_) + " has no function " + name);
  return found;
}

std::mutex& one_thread_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace lober::detail
