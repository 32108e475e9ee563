// The formats of curve files: which there are, and writing of many curves into one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/files.hpp"

namespace lober {

/// A format of curve files.
struct FormatInfo {
  Format format = Format::text;  ///< the format
  std::string_view name;         ///< as `name(format)` and the option --format have it
  std::string_view meaning;      ///< a line for people
  std::string_view suffixes;     ///< endings of names, the usual one first: ".h5 .hdf5"
  bool reads = false;            ///< whether it is read
  bool writes = false;           ///< whether it is written
  bool takes_several = false;    ///< whether a file can hold several curves
  std::string_view library;      ///< Debian's package of the library that it needs; empty for none
  std::string missing;  ///< why that library is not there, and what to do; empty where it is, or none is needed
};

/// All formats, in the order of the documentation. Loads libraries to see which are there: some milliseconds.
[[nodiscard]] LOBER_API std::vector<FormatInfo> formats();

/// The format that the ending of a name stands for, in either case; nothing where none does.
[[nodiscard]] LOBER_API std::optional<Format> format_of_name(std::string_view path);

/// How curves are written.
struct WriteOptions {
  std::optional<Format> format = {};  ///< nothing: by the ending of the name
  /// Whether curves are closed that do not say it themselves (Zone::closed): polygons, in formats that have them.
  bool closed = false;
  ZoneLines zone_lines = ZoneLines::where_needed;  ///< those of a Tecplot file
  /// Notes on where the file comes from, such as {"version", "0.3.0"}, {"input 1", "a.csv sha256 ..."}: into formats
  /// that have room for it (all but NPY and raw float64), in tables of text as comments before the first line.
  std::vector<std::pair<std::string, std::string>> provenance = {};
};

/// Writes curves into one file: Tecplot zones, GeoJSON features, an NPZ archive with points and offsets, VTK polydata,
/// WKT; one curve also as NPY, raw float64 or text, several also as a CSV table with the columns x, y and curve.
/// Numbers read back to the same bits. The file appears under its name when it is complete. Throws UsageError for an
/// ending that is that of no format, or of one that is only read, or that holds one curve while there are more;
/// DataError where it cannot be written, a coordinate is not finite, or the format's library is not there.
LOBER_API void write_curves(const std::string& path, std::span<const Zone> zones, const WriteOptions& options = {});

}  // namespace lober
