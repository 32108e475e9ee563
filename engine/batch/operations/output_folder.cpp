#include "engine/batch/operations/output_folder.hpp"

#include <sys/stat.h>

#include <algorithm>

#include "kernels/point.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

namespace fs = std::filesystem;

// Without links, as far as it is there.
fs::path without_links(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path), ignored);
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [rest, end] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return rest == folder.end() && end != path.end();
}

}  // namespace

OutputFolder::OutputFolder(const std::string& root, const std::string& manifest_path,
                           std::span<const std::string> inputs, const std::string& store)
    : manifest_path_(manifest_path), root_(root) {
  for (const std::string& input : inputs) protect(located(manifest_path, input));
  protect(manifest_path);
  if (store.empty()) return;
  for (const char* const file : {"", "-wal", "-shm"}) protect(store + file);
}

void OutputFolder::protect(const std::string& path) {
  struct ::stat status {};
  if (::stat(path.c_str(), &status) == 0) files_.emplace(status.st_dev, status.st_ino);
  paths_.insert(without_links(path).string());
}

bool OutputFolder::is_protected(const fs::path& resolved) const {
  struct ::stat status {};
  const bool exists = ::stat(resolved.c_str(), &status) == 0;
  return (exists && files_.contains({status.st_dev, status.st_ino})) || paths_.contains(resolved.string());
}

fs::path OutputFolder::resolved(const std::string& name) const {
  const fs::path path(name);
  if (path.is_absolute()) return without_links(path);
  return without_links(root_.empty() ? fs::path(located(manifest_path_, name)) : fs::path(root_) / path);
}

std::string OutputFolder::accept(const std::string& name) const {
  const fs::path folder = resolved("."), target = resolved(name);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw UsageError(root_ + " is not a folder; make it first");
  const auto refuse = [&](const std::string& why) { throw UsageError("\"" + name + "\" " + why); };
  if (!is_below(target, folder)) {
    refuse("lies outside of " + folder.string() +
           "; name a file below that folder, or make another one the root of outputs");
  }
  if (is_protected(target))
    refuse(
        "would replace an input of the manifest, or its store; name another file, in a folder of its own where a "
        "pattern of the inputs finds results of earlier runs");
  if (!fs::is_directory(target.parent_path(), ignored)) {
    refuse("needs the folder " + target.parent_path().string() + ", which does not exist; make it first");
  }
  const fs::file_status status = fs::symlink_status(target, ignored);
  if (fs::exists(status) && !(fs::is_regular_file(status) && is_curve_in_npy(target.string()))) {
    refuse("would replace a file that is not a curve in NPY, as earlier runs write it; name a new file");
  }
  return target.string();
}

}  // namespace lober::detail
