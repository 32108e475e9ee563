// Files of curves as units of the cache.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/batch/manifest/curve_source.hpp"

namespace lober::detail {

/// The zones of a file that jobs use as a unit, before anything is made of them. Only `load` reads more of the file
/// than its beginning, and nothing does if `points` says how many it has, about; a fault in one zone is an error of
/// that zone.
[[nodiscard]] CurveUnit file_unit(std::string path, std::vector<CurveSource> zones, std::size_t points = 0);

/// The digest of a zone, from the SHA-256 of its file. By contents only: no name goes in.
[[nodiscard]] std::string zone_digest(const std::string& file_sha256, const CurveSource& zone);

/// Throws DataError for a device, a pipe or a folder, and for a file of size zero: such files have no end, can be read
/// only once, or need an unknown amount of memory. Does not throw for a missing file.
void require_regular(const std::string& path);

/// SHA-256 of a file as it is now, read piece by piece. Throws DataError.
[[nodiscard]] std::string file_sha256(const std::string& path);

}  // namespace lober::detail
