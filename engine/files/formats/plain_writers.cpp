#include "engine/files/formats/plain_writers.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/base/finite.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/base/utf8.hpp"
#include "engine/files/formats/provenance.hpp"
#include "engine/files/npy_header.hpp"
#include "engine/files/tecplot.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

struct TextBlock {
  std::span<const Point> points;
  std::string text;
};

// `behind` stands at the end of each line.
void format_block(TextBlock& block, char separator, std::string_view behind) {
  constexpr std::size_t longest_number = 24;  // -1.2345678901234567e-308
  constexpr std::size_t longest_line = 2 * longest_number + 2;
  block.text.resize(block.points.size() * (longest_line + behind.size()));
  char* out = block.text.data();
  for (const Point& point : block.points) {
    out = std::to_chars(out, out + longest_number, point.x).ptr;
    *out++ = separator;
    out = std::to_chars(out, out + longest_number, point.y).ptr;
    out = std::copy(behind.begin(), behind.end(), out);
    *out++ = '\n';
  }
  block.text.resize(static_cast<std::size_t>(out - block.text.data()));
}

}  // namespace

void require_finite(const std::string& path, std::span<const Point> points) {
  if (const std::size_t bad = first_not_finite(points); bad != points.size()) {
    throw DataError(path + ": cannot be written: point " + std::to_string(bad) + " is not a finite number");
  }
}

void put_points(OutputFile& file, std::span<const Point> points, char separator, std::string_view behind) {
  constexpr std::size_t block_points = std::size_t{1} << 13;
  ordered_pipeline<TextBlock>(
      [&](TextBlock& block) {
        if (points.empty()) return false;
        block.points = points.first(std::min(points.size(), block_points));
        points = points.subspan(block.points.size());
        return true;
      },
      [&](TextBlock& block) { format_block(block, separator, behind); },
      [&](const TextBlock& block) { file.write(block.text); });
}

bool is_parted_by_tabs(std::string_view path) {
  constexpr std::string_view ending = ".tsv";
  if (path.size() < ending.size()) return false;
  path.remove_prefix(path.size() - ending.size());
  return std::equal(path.begin(), path.end(), ending.begin(), [](char c, char lower) {
    return (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) == lower;
  });
}

std::string_view as_bytes(std::span<const Point> points) {
  return {reinterpret_cast<const char*>(points.data()), points.size_bytes()};
}

void put_zones(OutputFile& file, std::span<const Zone> zones, ZoneLines lines) {
  file.write("VARIABLES=\"x\"\"y\"\n");
  for (const Zone& zone : zones) {
    // One curve without a title needs no ZONE line; Lober 1.8 writes such files.
    if (lines == ZoneLines::always || zones.size() > 1 || !zone.title.empty()) {
      const std::string title = zone.title.empty() ? "" : "T=" + tecplot_title(zone.title) + " ";
      file.write("ZONE " + title + "I=" + std::to_string(zone.points.size()) + "\n");
    }
    put_points(file, zone.points, '\t');
  }
}

void put_tecplot(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options) {
  file.write(comment_lines(options));
  put_zones(file, zones, options.zone_lines);
}

void put_text(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options) {
  const char separator = is_parted_by_tabs(file.path()) ? '\t' : ' ';
  file.write(comment_lines(options));
  for (const Zone& zone : zones) {
    if (zones.size() > 1) {
      // A line break would end it, and a control character make the file one of bytes.
      std::string title = as_utf8(zone.title);
      std::replace_if(
          title.begin(), title.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
      file.write(">" + (title.empty() ? "" : " " + title) + "\n");
    }
    put_points(file, zone.points, separator);
  }
}

void put_csv(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options) {
  file.write(comment_lines(options));
  if (zones.size() == 1) return put_points(file, zones.front().points, ',');
  file.write("x,y,curve\n");
  for (std::size_t k = 0; k < zones.size(); ++k) put_points(file, zones[k].points, ',', "," + std::to_string(k));
}

void put_npy(OutputFile& file, std::span<const Zone> zones, const WriteOptions&) {
  const std::span<const Point> points = zones.front().points;
  file.write(npy_head(std::array{points.size(), std::size_t{2}}));
  file.write(as_bytes(points));
}

void put_raw(OutputFile& file, std::span<const Zone> zones, const WriteOptions&) {
  file.write(as_bytes(zones.front().points));
}

}  // namespace lober::detail
