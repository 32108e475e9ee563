#include "engine/base/input_guard.hpp"

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace lober::detail {
namespace {

using Identity = std::pair<::dev_t, ::ino_t>;

struct Noted {
  std::mutex mutex;
  int guards = 0;
  // The identity sees hard links; the path sees a file that was replaced after it was read.
  std::set<Identity> files;
  std::set<std::string> paths;
  // Inputs as they were named: a batch opens each several times, and to follow a path takes many calls of the system.
  std::unordered_map<std::string, Identity> named;
};

Noted& noted() {
  static Noted all;
  return all;
}

/// Empty for a file without a path.
std::string canonical(const std::string& path) {
  if (path == "-") return {};
  std::error_code error;
  const std::filesystem::path resolved = std::filesystem::canonical(path, error);
  return error ? std::string{} : resolved.string();
}

}  // namespace

InputGuard::InputGuard() {
  const std::lock_guard lock(noted().mutex);
  ++noted().guards;
}

InputGuard::~InputGuard() {
  const std::lock_guard lock(noted().mutex);
  if (--noted().guards > 0) return;
  noted().files.clear();
  noted().paths.clear();
  noted().named.clear();
}

void note_input(const std::string& path, const struct ::stat& status) {
  if (!S_ISREG(status.st_mode)) return;
  const std::lock_guard lock(noted().mutex);
  if (noted().guards == 0) return;
  const Identity identity(status.st_dev, status.st_ino);
  const auto named = noted().named.find(path);
  if (named != noted().named.end() && named->second == identity) return;
  noted().named.insert_or_assign(path, identity);
  noted().files.insert(identity);
  if (std::string resolved = canonical(path); !resolved.empty()) noted().paths.insert(std::move(resolved));
}

void note_input(const std::string& path) {
  struct ::stat status {};
  if (::stat(path.c_str(), &status) == 0) note_input(path, status);
}

bool is_noted_input(const std::string& path, const struct ::stat& status) {
  if (!S_ISREG(status.st_mode)) return false;
  const std::lock_guard lock(noted().mutex);
  if (noted().guards == 0) return false;
  return noted().files.contains({status.st_dev, status.st_ino}) || noted().paths.contains(canonical(path));
}

}  // namespace lober::detail
