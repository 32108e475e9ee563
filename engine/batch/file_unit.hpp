// Files of curves as units of the cache.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/curve_cache.hpp"

namespace lober {

/// A zone of a file that jobs use.
struct FileZone {
  std::optional<std::size_t> zone;  ///< none: the only one
  bool closed = true;
  std::string name;  ///< in messages and exports
  friend bool operator==(const FileZone&, const FileZone&) = default;
};

/// The zones of a file as a unit. Only `load` reads more of it than its beginning; what is wrong with one zone is an
/// error of that one.
[[nodiscard]] CurveUnit file_unit(std::string path, std::vector<FileZone> zones);

/// How many points a file has: exact for NPY and raw float64, for text from the length of its first lines; 0 if it
/// cannot be read.
[[nodiscard]] std::size_t estimate_points(const std::string& path);

/// The digest of a zone, from the SHA-256 of its file. By contents only: no name goes in.
[[nodiscard]] std::string zone_digest(const std::string& file_sha256, const FileZone& zone);

/// Throws DataError for a device, a pipe or a folder: what has no end, or comes only once. Not for what is not there.
void require_regular(const std::string& path);

/// SHA-256 of a file as it is now. Throws DataError.
[[nodiscard]] std::string file_sha256(const std::string& path);

}  // namespace lober
