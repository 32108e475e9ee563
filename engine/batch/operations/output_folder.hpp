// The folder where the jobs of a manifest write their files.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace lober::detail {

/// A folder below which all outputs of a plan stay, and the files that they may not replace. Knows those as files,
/// under any name: by device and inode, and by the path that is left when links are resolved.
class OutputFolder {
 public:
  /// `root`: the folder; empty for that of the manifest. Takes down the inputs, the manifest, relative to which they
  /// are named, and the store, whose name may be empty.
  OutputFolder(const std::string& root, const std::string& manifest_path, std::span<const std::string> inputs,
               const std::string& store);

  /// The path of an output, relative names being those below the folder. Throws UsageError when it leads out of the
  /// folder, replaces an input, or replaces a file that is not an earlier result: a curve in NPY. May be called from
  /// several threads at once; jobs ask again before they write.
  [[nodiscard]] std::string accept(const std::string& name) const;

 private:
  void protect(const std::string& path);
  [[nodiscard]] bool is_protected(const std::filesystem::path& resolved) const;
  [[nodiscard]] std::filesystem::path resolved(const std::string& name) const;

  std::string manifest_path_, root_;
  std::set<std::pair<::dev_t, ::ino_t>> files_;
  std::set<std::string> paths_;
};

}  // namespace lober::detail
