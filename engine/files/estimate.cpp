#include <algorithm>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <system_error>

#include "engine/files/formats/begins.hpp"
#include "engine/files/formats/gzip.hpp"
#include "engine/files/head.hpp"
#include "engine/files/sniff.hpp"
#include "lober/curve/files.hpp"

namespace lober {
using namespace detail;

std::size_t estimate_points(const std::string& path) {
  if (std::error_code none; !std::filesystem::is_regular_file(path, none)) return 0;  // a pipe would be read from
  std::error_code error;
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(path, error));
  if (error) return 0;
  std::string head(std::min<std::size_t>(size, std::size_t{1} << 16), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size()))) return 0;
  const std::span<const std::byte> bytes = std::as_bytes(std::span(head));
  // The last four bytes are the length of what is compressed, modulo 2^32; a point takes as many bytes as in a raw
  // file, or more.
  if (is_gzip(bytes)) {
    std::string length(sizeof(std::uint32_t), '\0');
    file.seekg(-static_cast<std::streamoff>(length.size()), std::ios::end);
    if (!file.read(length.data(), static_cast<std::streamsize>(length.size()))) return 0;
    return std::max<std::size_t>(number_at(length, 0), size) / sizeof(Point);
  }
  if (sniff(bytes) != Content::text) return size / sizeof(Point);
  // A point is a list in JSON, ends at a comma in WKT, and is a line elsewhere.
  const char per_point = begins_json(bytes) ? '[' : begins_wkt(bytes) ? ',' : '\n';
  const auto lines = static_cast<std::size_t>(std::count(head.begin(), head.end(), per_point));
  return static_cast<std::size_t>(static_cast<double>(size) / static_cast<double>(head.size()) *
                                  static_cast<double>(std::max<std::size_t>(lines, 1)));
}

}  // namespace lober
