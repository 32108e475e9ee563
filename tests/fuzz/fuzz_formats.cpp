// Formats of other programs: NPZ, MAT, HDF5, NetCDF, GeoJSON, WKT, shapefiles, and any of them compressed by gzip.
// Curves that are read are written in formats that take several, and read back.
#include <algorithm>

#include "fuzz_reader.hpp"
#include "lober/curve/formats.hpp"

using namespace lober;
using namespace lober::detail;

namespace {

bool same_curves(const std::vector<Zone>& a, const std::vector<Zone>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Zone& p, const Zone& q) { return fuzz::same_bits(p.points, q.points); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
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
