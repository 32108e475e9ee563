// Reading and writing of curve files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/periods.hpp"

namespace lober {

/// Format of a file.
enum class Format : std::uint8_t {
  tecplot,    ///< Tecplot ASCII: VARIABLES, TITLE, ZONE lines, then one point a line
  text,       ///< a table: columns separated by commas, semicolons, blanks or tabs; a header line is allowed
  npy,        ///< NumPy: N x 2 or 2 x N floats or integers, or N complex numbers, in any order
  raw,        ///< native float64 pairs, nothing else
  npz,        ///< NumPy archive of named arrays
  mat,        ///< MATLAB, versions 4 to 7.3
  hdf5,       ///< HDF5, and NetCDF-4, which is HDF5
  netcdf,     ///< NetCDF in its classic formats
  geojson,    ///< GeoJSON
  wkt,        ///< well-known text of geometries
  shapefile,  ///< ESRI shapefile, the .shp alone
  vtk,        ///< VTK polydata in XML; written, not read
  csv,        ///< a table of text with commas between its columns, as it is written; read as `text`
};
/// The name of the format.
[[nodiscard]] LOBER_API std::string_view name(Format format);

/// One curve of a file: a zone of Tecplot's, a curve of a table, a ring of a polygon. NPY and raw float64 have exactly
/// one.
struct Zone {
  std::string title;          ///< title of the curve; empty where the file has none
  std::vector<Point> points;  ///< in the order of the file
  std::size_t line = 1;       ///< where it starts in a table or a Tecplot file, counted from 1
  bool hole = false;          ///< a hole in the last zone before it that is none
  /// Numbers that belong to it, such as {"area", 0.5}: into formats that have room for them. Not read.
  std::vector<std::pair<std::string, double>> numbers = {};
  /// Whether it is closed, for formats that tell polygons from lines. Nothing: as WriteOptions::closed says. Not read.
  std::optional<bool> closed = {};
};

/// The zones of a file.
struct CurveFile {
  std::string path;              ///< the path as it was given
  Format format = Format::text;  ///< format of the content
  std::string sha256;            ///< hash of the whole file, lower-case hexadecimal
  std::vector<Zone> zones;       ///< in the order of the file
  std::string header;  ///< names of columns, as the first line of a text file or the variables of a Tecplot file
  /// Titles are the values of the column or array that groups points, or the numbers of rows: a number behind '#' is
  /// one of these, not a position.
  bool titled_by_group = false;
};

/// Options of reading.
struct ReadOptions {
  bool hash = true;  ///< compute `sha256`; reading is faster without
  /// Columns of a table: two names of its header, or numbers counted from 1, and perhaps the column that says which
  /// curve a row belongs to: "lon,lat", "2,3", "x,y,by=id". Empty: a table has two columns, or more, of which the first
  /// two are named x and y or longitude and latitude.
  ///
  /// Arrays of an NPZ, MAT, HDF5 or NetCDF file: two of one shape, "x,y" or "/group/x,/group/y", or one of points,
  /// "xy": N x 2 or 2 x N numbers, or complex ones; perhaps "by=ID", an array that says which curve each point belongs
  /// to, "offsets=O", where each curve begins and the last one ends, or "counts=N", the number of points of each.
  /// Arrays of two axes are one curve a row (MATLAB: a column); points where a coordinate is NaN are not there. Empty:
  /// arrays called x and y, or longitude and latitude, or the only one of points, parted as the attributes of CF say.
  /// Names with commas are in quotes: "\"x, m\",\"y, m\"".
  std::string columns = {};
  /// Periods of x and y, for `read_curve`: a curve that was stored modulo them is followed across the seam.
  Periods periods = {};
};

/// Reads every zone of a file. The format is chosen by the content, never by the name. The file is
/// read into memory and text is parsed in parallel. The curves of a table are parted by lines that begin with '>' (as
/// GMT has them; the rest is the title), by rows of NaN, by blank lines, unless there is one behind each point, or by
/// the column that groups rows. Throws DataError "path:line: what is wrong" for a file that is missing, unreadable,
/// empty, has a zone without points, a line that is not two finite numbers, a column count other than two, a declared
/// count (I=, N=) that contradicts the points, or a truncated binary file, and for a format whose library is not there
/// (lober/curve/formats.hpp). Files compressed by gzip are unpacked. Where a file has no lines (it is missing or
/// binary), the message is "path: what is wrong". A pipe is read to its end;
/// "-" is standard input.
[[nodiscard]] LOBER_API CurveFile read_curve_file(const std::string& path, const ReadOptions& options = {});

/// A curve named on a command line: `FILE`, or `FILE#K` for zone K counted from 0, or `FILE#TITLE`; with
/// `FILE:COLUMNS`, as ReadOptions::columns, in place of FILE. (A file whose name really contains '#' or ':' is found
/// first.) Closed curves lose a last vertex that repeats the first.
struct NamedCurve {
  Curve curve;            ///< the curve
  std::string file;       ///< the path without the zone
  std::string sha256;     ///< hash of the whole file
  std::size_t zone = 0;   ///< number of its zone, from 0
  std::size_t zones = 1;  ///< number of zones of the file
  std::string group;      ///< its title, where titles and not positions name the zones (CurveFile::titled_by_group)
  /// Says how a curve was closed, or that it consists of longitudes and latitudes; nearly always empty.
  std::string remark;
  std::string header{};  ///< names of the columns, as in CurveFile
  /// Says which segment of a curve of longitudes and latitudes runs back across the whole map, because the curve
  /// crosses the date line: its area is not the one of the earth. ReadOptions::periods mends it. Nearly always empty.
  std::string warning{};
};

/// Reads one curve and validates it. Throws DataError as `read_curve_file` and `validate` do, and when the
/// file has several zones and none is chosen, or the chosen one is not there.
[[nodiscard]] LOBER_API NamedCurve read_curve(const std::string& spec, bool closed, const ReadOptions& options = {});

/// All curves of `FILE` or `FILE:COLUMNS`, or the one that `FILE#K` or `FILE#TITLE` names (NamedCurve), as they are in
/// the file. Throws as `read_curve_file`, and DataError where the zone is not there, UsageError where columns are
/// chosen by `spec` and by the options.
[[nodiscard]] LOBER_API CurveFile read_curves(const std::string& spec, const ReadOptions& options = {});

/// Whether a file names its columns as latitude and longitude, in that order; nothing where it names neither.
[[nodiscard]] LOBER_API std::optional<bool> latitude_first(const CurveFile& file);
/// Throws DataError when one curve has columns of latitude and longitude and the other of longitude and latitude.
LOBER_API void require_same_columns(const Curve& first, const Curve& second);
/// Says that two curves of longitudes and latitudes count longitudes differently, one from -180 to 180 and the other
/// from 0 to 360, so that they do not meet where they are on the same place of the earth: their boxes overlap when one
/// of them is moved by 360. Nearly always empty, also where files do not name their columns. The period mends it
/// (ReadOptions::periods and move_near). O(N).
[[nodiscard]] LOBER_API std::string longitudes_warning(const Curve& first, const Curve& second);
/// NamedCurve::warning of a curve whose file has this header. O(N), parallel.
[[nodiscard]] LOBER_API std::string date_line_warning(std::string_view header, std::span<const Point> points);
/// The remedy of both as a manifest has it: `periodic = "x=360"`, or of y where latitudes come first.
[[nodiscard]] LOBER_API std::string period_of_longitudes(const Curve& curve);
/// Whether a file begins as text does; false for one that is empty or cannot be read. Zones of other files may have
/// ids.
[[nodiscard]] LOBER_API bool begins_as_text(const std::string& path);

/// The number of points of a file: exact for NPY and raw float64; for text, GeoJSON and WKT an estimate from the first
/// lines or positions, for files compressed by gzip one from above. 0 if the file cannot be read. At most 64 KiB are
/// read.
[[nodiscard]] LOBER_API std::size_t estimate_points(const std::string& path);

/// Writers. Numbers are written in the shortest form that reads back to the same bits. The file appears under
/// its name only when it is complete (written beside it, then renamed); on failure an existing file is left
/// as it was. A path that is not a regular file (a pipe, /dev/stdout, "-" for standard output) is written directly.
/// They throw DataError when the file cannot be written or a coordinate is not finite.
///
/// Raw float64 has no signature: coordinates whose bytes all happen to be printable characters would be read as
/// text. Numbers of few digits never are, because their low bytes are zero.
///
/// A single zone without a title needs no ZONE line in a Tecplot file.
enum class ZoneLines : std::uint8_t { where_needed, always };
/// Writes zones as Tecplot ASCII.
LOBER_API void write_tecplot(const std::string& path, std::span<const Zone> zones,
                             ZoneLines lines = ZoneLines::where_needed);
/// Writes a line for each point.
LOBER_API void write_text(const std::string& path, std::span<const Point> points, char separator = ' ');
/// Writes an array of N x 2 float64.
LOBER_API void write_npy(const std::string& path, std::span<const Point> points);
/// Writes native float64 pairs.
LOBER_API void write_raw(const std::string& path, std::span<const Point> points);
/// Several curves, in these and other formats: write_curves (lober/curve/formats.hpp).

/// Writes `content` in the same way: complete under its name, or not at all.
LOBER_API void write_file(const std::string& path, std::string_view content);

/// SHA-256 (FIPS 180-4) of bytes in memory, lower-case hexadecimal.
[[nodiscard]] LOBER_API std::string sha256(std::span<const std::byte> bytes);
/// SHA-256 of a regular file, one mebibyte of which is in memory at a time. Throws DataError "path: reason", also for a
/// file that changes meanwhile.
[[nodiscard]] LOBER_API std::string sha256_of_file(const std::string& path);

/// Whether a file has the form that `write_npy` gives a curve, byte for byte, not a table or an array of another shape.
/// O(1).
[[nodiscard]] LOBER_API bool is_curve_in_npy(const std::string& path);

}  // namespace lober
