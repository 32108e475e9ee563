#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <filesystem>
#include <fstream>

#include "engine/base/finite.hpp"
#include "engine/base/output_file.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/files/binary_file.hpp"
#include "engine/files/tecplot.hpp"
#include "lober/curve/files.hpp"

namespace lober {
using namespace detail;
namespace {

/// Points that cannot be read back are not written.
void require_finite(const std::string& path, std::span<const Point> points) {
  if (const std::size_t bad = first_not_finite(points); bad != points.size()) {
    throw DataError(path + ": cannot be written: point " + std::to_string(bad) + " is not a finite number");
  }
}

struct TextBlock {
  std::span<const Point> points;
  std::string text;
};

void format_block(TextBlock& block, char separator) {
  constexpr std::size_t longest_number = 24;  // -1.2345678901234567e-308
  constexpr std::size_t longest_line = 2 * longest_number + 2;
  block.text.resize(block.points.size() * longest_line);
  char* out = block.text.data();
  for (const Point& point : block.points) {
    out = std::to_chars(out, out + longest_number, point.x).ptr;
    *out++ = separator;
    out = std::to_chars(out, out + longest_number, point.y).ptr;
    *out++ = '\n';
  }
  block.text.resize(static_cast<std::size_t>(out - block.text.data()));
}

/// Formats in parallel, writes in order.
void write_points(OutputFile& file, std::span<const Point> points, char separator) {
  constexpr std::size_t block_points = std::size_t{1} << 13;
  ordered_pipeline<TextBlock>(
      [&](TextBlock& block) {
        if (points.empty()) return false;
        block.points = points.first(std::min(points.size(), block_points));
        points = points.subspan(block.points.size());
        return true;
      },
      [&](TextBlock& block) { format_block(block, separator); },
      [&](const TextBlock& block) { file.write(block.text); });
}

std::string_view bytes_of(std::span<const Point> points) {
  return {reinterpret_cast<const char*>(points.data()), points.size_bytes()};
}

}  // namespace

std::string detail::npy_head(std::span<const std::size_t> shape) {
  constexpr std::size_t before_header = 10;  // magic string, version, length of the header
  constexpr std::size_t alignment = 64;
  const char order = std::endian::native == std::endian::little ? '<' : '>';
  std::string header = std::string("{'descr': '") + order + "f8', 'fortran_order': False, 'shape': (";
  for (const std::size_t& size : shape) header += std::to_string(size) + (&size == &shape.back() ? "" : ", ");
  header += "), }";
  const std::size_t unpadded = before_header + header.size() + 1;
  header.append((alignment - unpadded % alignment) % alignment, ' ');
  header += '\n';
  // Version 1.0; the length has two bytes, the low one first.
  std::string head("\x93NUMPY\x01\x00", 8);
  head += static_cast<char>(header.size() & 0xFF);
  head += static_cast<char>(header.size() >> 8);
  return head + header;
}

void write_file(const std::string& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

void write_text(const std::string& path, std::span<const Point> points, char separator) {
  if (std::string_view(" \t,;").find(separator) == std::string_view::npos) {
    throw UsageError("write_text: the separator has to be a blank, a tab, a comma or a semicolon");
  }
  require_finite(path, points);
  OutputFile file(path);
  write_points(file, points, separator);
  file.commit();
}

void write_tecplot(const std::string& path, std::span<const Zone> zones, ZoneLines lines) {
  for (const Zone& zone : zones) require_finite(path, zone.points);
  OutputFile file(path);
  file.write("VARIABLES=\"x\"\"y\"\n");
  for (const Zone& zone : zones) {
    // One curve without a title needs no ZONE line; Lober 1.8 writes such files.
    if (lines == ZoneLines::always || zones.size() > 1 || !zone.title.empty()) {
      const std::string title = zone.title.empty() ? "" : "T=" + tecplot_title(zone.title) + " ";
      file.write("ZONE " + title + "I=" + std::to_string(zone.points.size()) + "\n");
    }
    write_points(file, zone.points, '\t');
  }
  file.commit();
}

bool is_curve_in_npy(const std::string& path) {
  std::error_code ignored;
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(path, ignored));
  const std::size_t head_size = npy_head(std::array{size / sizeof(Point), std::size_t{2}}).size();
  if (ignored || size < head_size) return false;
  const std::string expected = npy_head(std::array{(size - head_size) / sizeof(Point), std::size_t{2}});
  std::string head(expected.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  return file.read(head.data(), static_cast<std::streamsize>(head.size())) && head == expected;
}

void write_npy(const std::string& path, std::span<const Point> points) {
  require_finite(path, points);
  OutputFile file(path);
  file.write(npy_head(std::array{points.size(), std::size_t{2}}));
  file.write(bytes_of(points));
  file.commit();
}

void write_raw(const std::string& path, std::span<const Point> points) {
  require_finite(path, points);
  OutputFile file(path);
  file.write(bytes_of(points));
  file.commit();
}

}  // namespace lober
