// Formats of other programs: NPZ, MAT, HDF5, NetCDF, GeoJSON, WKT, shapefiles, and any of them compressed by gzip.
// Curves that are read are written in formats that take several, and read back. Inputs that hold a file of HDF5 are
// left out unless LOBER_FUZZ_HDF5 is set: the library of Debian 12 (1.10.8) frees memory twice while it lists the links
// of damaged groups.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "fuzz_reader.hpp"
#include "lober/curve/formats.hpp"

using namespace lober;
using namespace lober::detail;

namespace {

bool same_curves(const std::vector<Zone>& a, const std::vector<Zone>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Zone& p, const Zone& q) { return fuzz::same_bits(p.points, q.points); });
}

bool is_left_out(std::string_view bytes) {
  static const bool with_hdf5 = std::getenv("LOBER_FUZZ_HDF5") != nullptr;
  return !with_hdf5 && bytes.find("\x89HDF\r\n\x1a\n") != std::string_view::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  if (is_left_out({reinterpret_cast<const char*>(data), size})) return 0;
  std::string reason;
  (void)fuzz::read(bytes, default_chunk_size, reason, "x,y,by=id");
  const auto file = fuzz::read(bytes);
  if (!file || file->format <= Format::raw) return 0;
  for (const Format format : {Format::geojson, Format::wkt, Format::npz, Format::text}) {
    write_curves(fuzz::scratch(), file->zones, {.format = format});
    const CurveFile again = fuzz::read_back();
    fuzz::require(same_curves(file->zones, again.zones), "curves are not read back");
  }
  return 0;
}
