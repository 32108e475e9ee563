// NPY files of points.
#include <bit>
#include <cstdint>

#include "engine/base/parallel/parallel.hpp"
#include "engine/files/binary_file.hpp"
#include "engine/files/byte_order.hpp"
#include "engine/files/npy_header.hpp"
#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

/// How the numbers lie in the file.
struct Layout {
  std::size_t points = 0;
  std::size_t item = 8;      ///< bytes of a number
  bool swap = false;         ///< whether the byte order is the other one
  bool interleaved = false;  ///< x y x y ..., otherwise all x, then all y
};

Layout layout_of(const NpyHeader& header, const std::string& path) {
  const std::string_view type = header.type;
  constexpr bool little = std::endian::native == std::endian::little;
  const bool known = type.size() == 3 && (type.ends_with("f8") || type.ends_with("f4")) &&
                     std::string_view("<>=").find(type.front()) != std::string_view::npos;
  if (!known) throw DataError(path + ": element type " + quoted_text(type) + ": expected <f8, >f8, <f4 or >f4");
  const std::vector<std::size_t>& shape = header.shape;
  const bool rows = shape.size() == 2 && shape[1] == 2;
  const bool columns = shape.size() == 2 && shape[0] == 2;
  if (!rows && !columns) {
    std::string text;
    for (const std::size_t size : shape) text += (text.empty() ? "" : ", ") + std::to_string(size);
    throw DataError(path + ": shape (" + text + "): expected (N, 2) or (2, N)");
  }
  Layout layout;
  layout.points = rows ? shape[0] : shape[1];
  layout.item = type.ends_with("f8") ? 8 : 4;
  layout.swap = type.front() != '=' && (type.front() == '<') != little;
  layout.interleaved = rows != header.fortran_order;
  return layout;
}

template <typename Float, typename Unsigned>
void convert(const std::byte* data, const Layout& layout, std::span<Point> points) {
  constexpr std::size_t grain = std::size_t{1} << 16;
  const std::size_t step = layout.interleaved ? 2 * sizeof(Float) : sizeof(Float);
  const std::byte* const ys = data + (layout.interleaved ? 1 : layout.points) * sizeof(Float);
  for_each_block(layout.points, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points[i] = {load_number<Float, Unsigned>(data + i * step, layout.swap),
                   load_number<Float, Unsigned>(ys + i * step, layout.swap)};
    }
  });
}

}  // namespace

void read_npy(std::span<const std::byte> bytes, CurveFile& file) {
  file.format = Format::npy;
  const auto fail = [&](const std::string& message) { throw DataError(file.path + ": " + message); };
  const NpyHeader header = read_npy_header(bytes, file.path);
  const Layout layout = layout_of(header, file.path);

  const std::span<const std::byte> data = bytes.subspan(header.size);
  const std::size_t point_size = 2 * layout.item;
  if (data.size() % point_size != 0 || data.size() / point_size != layout.points) {
    fail("the NPY header promises " + std::to_string(layout.points) + " points of " + std::to_string(point_size) +
         " bytes, the file has " + std::to_string(data.size()) + " bytes for them");
  }
  std::vector<Point> points(layout.points);
  if (layout.item == 8) {
    convert<double, std::uint64_t>(data.data(), layout, points);
  } else {
    convert<float, std::uint32_t>(data.data(), layout, points);
  }
  add_only_zone(std::move(points), file);
}

}  // namespace lober::detail
