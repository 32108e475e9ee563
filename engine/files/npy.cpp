// NPY files of points.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "engine/base/parallel/parallel.hpp"
#include "engine/files/binary_file.hpp"
#include "engine/files/byte_order.hpp"
#include "engine/files/formats/npy_numbers.hpp"
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

std::string shape_text(const NpyHeader& header) {
  std::string text;
  for (const std::size_t size : header.shape) text += (text.empty() ? "" : ", ") + std::to_string(size);
  return "shape (" + text + ")";
}

Layout layout_of(const NpyHeader& header, const std::string& path) {
  const std::string_view type = header.type;
  constexpr bool little = std::endian::native == std::endian::little;
  const std::vector<std::size_t>& shape = header.shape;
  const bool rows = shape.size() == 2 && shape[1] == 2;
  const bool columns = shape.size() == 2 && shape[0] == 2;
  if (!rows && !columns) throw DataError(path + ": " + shape_text(header) + ": expected (N, 2) or (2, N)");
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

namespace {

// Whether the numbers are floats of four or eight bytes, which are read without a copy.
bool has_usual_type(const NpyHeader& header) {
  const std::string_view type = header.type;
  return type.size() == 3 && (type.ends_with("f8") || type.ends_with("f4")) &&
         std::string_view("<>=").find(type.front()) != std::string_view::npos;
}

// Points of any other numbers.
std::vector<Point> points_of(const NpyHeader& header, std::span<const std::byte> data, const std::string& path) {
  const bool has_order =
      !header.type.empty() && std::string_view("<>=|").find(header.type.front()) != std::string_view::npos;
  if (!has_order || !holds_numbers(header) || header.type == "|f8" || header.type == "|f4") {
    throw DataError(path + ": element type " + quoted_text(header.type) +
                    ": expected numbers, such as <f8, >f4, <i4 or <c16");
  }
  if (holds_complex_numbers(header)) {
    if (std::count_if(header.shape.begin(), header.shape.end(), [](std::size_t size) { return size != 1; }) > 1) {
      throw DataError(path + ": " + shape_text(header) + " of complex numbers: expected (N,)");
    }
    const Buffer<double> parts = npy_numbers(header, data, path);
    std::vector<Point> points(parts.size() / 2);
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = {parts[2 * k], parts[2 * k + 1]};
    return points;
  }
  const std::size_t count = layout_of(header, path).points;
  const bool rows = header.shape[1] == 2;
  const Buffer<double> numbers = npy_numbers(header, data, path);
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    points[k] = rows ? Point{numbers[2 * k], numbers[2 * k + 1]} : Point{numbers[k], numbers[count + k]};
  }
  return points;
}

}  // namespace

void read_npy(std::span<const std::byte> bytes, CurveFile& file) {
  file.format = Format::npy;
  const auto fail = [&](const std::string& message) { throw DataError(file.path + ": " + message); };
  const NpyHeader header = read_npy_header(bytes, file.path);
  const std::span<const std::byte> data = bytes.subspan(header.size);
  if (!has_usual_type(header)) return add_only_zone(points_of(header, data, file.path), file);
  const Layout layout = layout_of(header, file.path);
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
