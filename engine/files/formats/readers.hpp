// The readers and writers of formats, one file each; format_table.cpp says which there are.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "lober/curve/files.hpp"
#include "lober/curve/formats.hpp"

namespace lober::detail {

/// The input of a reader, beside the name of the file, which messages begin with (CurveFile::path).
struct FileSource {
  std::span<const std::byte> bytes;
  std::string_view columns;    ///< ReadOptions::columns
  std::size_t chunk_size = 0;  ///< text is parsed in parallel in chunks of it

  [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// They add zones to `file`. Throw DataError "path: ..."; those that work with a library of others, also where it is
/// not there.
void read_npz(const FileSource& source, CurveFile& file);
void read_mat(const FileSource& source, CurveFile& file);
void read_mat73(const FileSource& source, CurveFile& file);
void read_hdf5(const FileSource& source, CurveFile& file);
void read_netcdf(const FileSource& source, CurveFile& file);
void read_geojson(const FileSource& source, CurveFile& file);
void read_wkt(const FileSource& source, CurveFile& file);
void read_shapefile(const FileSource& source, CurveFile& file);

/// Whether text begins with a geometry in WKT, perhaps behind comments.
[[nodiscard]] bool is_wkt(std::string_view text);

/// Whether a zone is written as closed.
[[nodiscard]] inline bool is_closed(const Zone& zone, const WriteOptions& options) {
  return zone.closed.value_or(options.closed);
}

/// The bytes of a file. Coordinates are finite (write_curves asks).
[[nodiscard]] std::string npz_bytes(std::span<const Zone> zones, const WriteOptions& options);
[[nodiscard]] std::string geojson_bytes(std::span<const Zone> zones, const WriteOptions& options);
[[nodiscard]] std::string wkt_bytes(std::span<const Zone> zones, const WriteOptions& options);
[[nodiscard]] std::string vtk_bytes(std::span<const Zone> zones, const WriteOptions& options);

}  // namespace lober::detail
