#include "engine/files/formats/format_table.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "engine/files/binary_file.hpp"
#include "engine/files/formats/begins.hpp"
#include "engine/files/formats/libraries.hpp"
#include "engine/files/formats/plain_writers.hpp"
#include "engine/files/npy_header.hpp"
#include "engine/files/plausible.hpp"
#include "engine/files/sniff.hpp"
#include "engine/files/text_file.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

void read_table(const FileSource& source, CurveFile& file) {
  read_text(source.text().substr(byte_order_mark(source.bytes)), source.columns, source.chunk_size, file);
}

void read_npy_file(const FileSource& source, CurveFile& file) {
  read_npy(source.bytes, file);
}

void read_pairs(const FileSource& source, CurveFile& file) {
  if (!insists_on_raw(file.path) && source.bytes.size() % sizeof(Point) == 0) {  // else the size is wrong
    if (const std::string why = implausible_raw(file.path, source.bytes); !why.empty()) {
      throw DataError(file.path + ": " + why);
    }
  }
  read_raw(source.bytes, file);
}

// A writer that makes the whole file in memory.
template <std::string (*bytes)(std::span<const Zone>, const WriteOptions&)>
void write_at_once(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options) {
  file.write(bytes(zones, options));
}

// In the order of the documentation.
constexpr std::array<FormatEntry, 13> table{{
    {Format::npy, "npy", "a NumPy array, N x 2 or 2 x N, or complex", ".npy", begins_npy, read_npy_file, put_npy, false,
     false, nullptr},
    {Format::csv, "csv", "columns of text, parted by commas", ".csv", nullptr, read_table, put_csv, true, true,
     nullptr},
    {Format::text, "text", "columns of text, parted by blanks, tabs, commas or semicolons", ".txt .tsv .xy .gmt",
     nullptr, read_table, put_text, true, true, nullptr},
    {Format::tecplot, "tecplot", "Tecplot ASCII, point data", ".dat .tec", nullptr, read_table, put_tecplot, true, true,
     nullptr},
    {Format::raw, "raw", "native float64 pairs, nothing else", ".f64 .raw", nullptr, read_pairs, put_raw, false, false,
     nullptr},
    {Format::npz, "npz", "a NumPy archive of named arrays", ".npz", begins_npz, read_npz, write_at_once<npz_bytes>,
     true, true, &zip_library},
    {Format::mat, "mat", "MATLAB arrays, versions 4 to 7.3", ".mat", begins_mat, read_mat, nullptr, true, true,
     &matio_library},
    {Format::hdf5, "hdf5", "HDF5 datasets, and variables of NetCDF-4", ".h5 .hdf5 .nc4", begins_hdf5, read_hdf5,
     nullptr, true, true, &hdf5_library},
    {Format::netcdf, "netcdf", "variables of NetCDF, classic", ".nc .cdf", begins_netcdf, read_netcdf, nullptr, true,
     true, nullptr},
    {Format::geojson, "geojson", "GeoJSON: polygons, lines, points", ".geojson .json", begins_json, read_geojson,
     write_at_once<geojson_bytes>, true, false, nullptr},
    {Format::wkt, "wkt", "well-known text: POLYGON ((...)) and its like", ".wkt", begins_wkt, read_wkt,
     write_at_once<wkt_bytes>, true, false, nullptr},
    {Format::shapefile, "shapefile", "ESRI shapefile, the .shp alone", ".shp", begins_shapefile, read_shapefile,
     nullptr, true, false, &shapelib_library},
    {Format::vtk, "vtk", "VTK polydata, for ParaView", ".vtp", nullptr, nullptr, write_at_once<vtk_bytes>, true, false,
     nullptr},
}};

}  // namespace

std::span<const FormatEntry> format_table() {
  return table;
}

const FormatEntry& entry_of(Format format) {
  return *std::find_if(table.begin(), table.end(), [&](const FormatEntry& entry) { return entry.format == format; });
}

std::string written_endings(bool of_several) {
  std::string text;
  for (const FormatEntry& entry : format_table()) {
    if (entry.write == nullptr || (of_several && !entry.holds_several)) continue;
    text += (text.empty() ? "" : ", ") + std::string(entry.suffixes.substr(0, entry.suffixes.find(' ')));
    if (entry.format == Format::tecplot || entry.format == Format::vtk) text += " (" + std::string(entry.name) + ")";
  }
  return text;
}

const FormatEntry& recognised(std::span<const std::byte> bytes) {
  const auto* const found = std::find_if(table.begin(), table.end(), [&](const FormatEntry& entry) {
    return entry.begins != nullptr && entry.begins(bytes);
  });
  if (found != table.end()) return *found;
  return entry_of(sniff(bytes) == Content::text ? Format::text : Format::raw);
}

}  // namespace lober::detail

namespace lober {
using namespace detail;

std::string_view name(Format format) {
  return entry_of(format).name;
}

std::vector<FormatInfo> formats() {
  std::vector<FormatInfo> all;
  for (const FormatEntry& entry : format_table()) {
    const OptionalLibrary* const library = entry.library;
    all.push_back({entry.format, entry.name, entry.meaning, entry.suffixes, entry.read != nullptr,
                   entry.write != nullptr, entry.holds_several, library == nullptr ? "" : library->package(),
                   library == nullptr ? "" : library->reason_it_is_missing()});
  }
  return all;
}

std::optional<Format> format_of_name(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::string ending(path.substr(dot));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const FormatEntry& entry : format_table()) {
    for (std::string_view rest = entry.suffixes; !rest.empty();) {
      const std::size_t blank = std::min(rest.find(' '), rest.size());
      if (rest.substr(0, blank) == ending) return entry.format;
      rest.remove_prefix(std::min(blank + 1, rest.size()));
    }
  }
  return std::nullopt;
}

}  // namespace lober
