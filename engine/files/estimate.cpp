#include <algorithm>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <system_error>

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
  if (sniff(std::as_bytes(std::span(head))) != Content::text) return size / sizeof(Point);
  const auto lines = static_cast<std::size_t>(std::count(head.begin(), head.end(), '\n'));
  return static_cast<std::size_t>(static_cast<double>(size) / static_cast<double>(head.size()) *
                                  static_cast<double>(std::max<std::size_t>(lines, 1)));
}

}  // namespace lober
