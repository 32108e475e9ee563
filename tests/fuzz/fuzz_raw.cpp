// Raw float64, and the choice between it and the other formats.
#include "fuzz_reader.hpp"
#include "lober/curve/files.hpp"

using namespace lober;
using namespace lober::detail;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::read(std::as_bytes(std::span(data, size)));
  if (!file || file->format != Format::raw) return 0;
  const std::vector<Point>& points = file->zones.front().points;
  write_raw(fuzz::scratch(), points);
  const CurveFile again = fuzz::read_back();
  fuzz::require(again.format == Format::raw && fuzz::same_bits(points, again.zones.front().points),
                "raw is not read back");
  return 0;
}
