// NPY: whatever follows the magic string.
#include <vector>

#include "fuzz_reader.hpp"
#include "lober/curve/files.hpp"

using namespace lober;
using namespace lober::detail;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view magic = "\x93NUMPY";
  std::vector<std::byte> bytes(magic.size() + size);
  std::copy_n(reinterpret_cast<const std::byte*>(magic.data()), magic.size(), bytes.begin());
  std::copy_n(reinterpret_cast<const std::byte*>(data), size, bytes.begin() + magic.size());
  const auto file = fuzz::read(bytes);
  if (!file) return 0;
  fuzz::require(file->format == Format::npy, "NPY is taken for something else");
  const std::vector<Point>& points = file->zones.front().points;
  write_npy(fuzz::scratch(), points);
  fuzz::require(fuzz::same_bits(points, fuzz::read_back().zones.front().points), "NPY is not read back");
  return 0;
}
