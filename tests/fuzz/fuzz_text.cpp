// Text and Tecplot. The first byte chooses where the text is cut into chunks, which must make no difference, and the
// columns.
#include <array>

#include "fuzz_reader.hpp"
#include "lober/curve/files.hpp"

using namespace lober;
using namespace lober::detail;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<const char*, 4> choices{"", "2,1", "1,3", "1,2,by=3"};
  const std::size_t chunk_size = 1 + data[0] % 64;
  const char* const columns = choices[data[0] / 64];
  const auto bytes = std::as_bytes(std::span(data, size)).subspan(1);
  std::string error;
  std::string error_in_chunks;
  const auto file = fuzz::read(bytes, default_chunk_size, error, columns);
  const auto in_chunks = fuzz::read(bytes, chunk_size, error_in_chunks, columns);
  fuzz::require(error == error_in_chunks, "chunks change the error");
  if (!file || (file->format != Format::text && file->format != Format::tecplot)) return 0;
  fuzz::require(in_chunks->format == file->format && fuzz::same_zones(*file, *in_chunks), "chunks change the zones");

  write_tecplot(fuzz::scratch(), file->zones);
  fuzz::require(fuzz::same_zones(*file, fuzz::read_back()), "Tecplot is not read back");
  const std::vector<Point>& points = file->zones.front().points;
  write_text(fuzz::scratch(), points, " \t,;"[data[0] % 4]);
  fuzz::require(fuzz::same_bits(points, fuzz::read_back().zones.front().points), "text is not read back");
  return 0;
}
