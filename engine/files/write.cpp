#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "engine/base/output_file.hpp"
#include "engine/files/formats/format_table.hpp"
#include "engine/files/formats/plain_writers.hpp"
#include "engine/files/npy_header.hpp"
#include "lober/curve/files.hpp"

namespace lober {
using namespace detail;
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
  put_points(file, points, separator);
  file.commit();
}

void write_tecplot(const std::string& path, std::span<const Zone> zones, ZoneLines lines) {
  for (const Zone& zone : zones) require_finite(path, zone.points);
  OutputFile file(path);
  put_zones(file, zones, lines);
  file.commit();
}

void write_curves(const std::string& path, std::span<const Zone> zones, const WriteOptions& options) {
  const std::optional<Format> format = options.format ? options.format : format_of_name(path);
  const FormatEntry* const entry = format ? &entry_of(*format) : nullptr;
  if (entry == nullptr || entry->write == nullptr) {
    const std::string what = entry == nullptr ? "the ending does not name a format"
                                              : "files of the format " + std::string(entry->name) + " are only read";
    throw UsageError(path + ": " + what + "; curves are written as " + written_endings());
  }
  if (zones.size() > 1 && !entry->holds_several) {
    throw UsageError(path + ": several curves need another format than " + std::string(entry->name) +
                     ", which holds one; several are written as " + written_endings(true));
  }
  if (zones.empty() && !entry->holds_several) throw UsageError(path + ": there is no curve to write");
  for (const Zone& zone : zones) require_finite(path, zone.points);
  if (entry->library != nullptr && !entry->library->is_present()) {
    throw DataError(path + ": cannot be written: " + entry->library->reason_it_is_missing());
  }
  OutputFile file(path);
  entry->write(file, zones, options);
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
  file.write(as_bytes(points));
  file.commit();
}

void write_raw(const std::string& path, std::span<const Point> points) {
  require_finite(path, points);
  OutputFile file(path);
  file.write(as_bytes(points));
  file.commit();
}

}  // namespace lober
