#include "engine/files/formats/begins.hpp"

#include <algorithm>
#include <string_view>

#include "engine/files/formats/readers.hpp"
#include "engine/files/head.hpp"
#include "engine/files/npy_header.hpp"
#include "engine/files/sniff.hpp"

namespace lober::detail {
namespace {

using namespace std::string_view_literals;  // some hold zero bytes

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1A\n"sv;

/// MAT files of version 4 have no mark: a type, sizes, a flag, and the length of a name that follows.
bool is_mat4(std::string_view bytes) {
  constexpr std::size_t header = 20;
  constexpr std::uint32_t longest_name = 64;
  if (bytes.size() < header) return false;
  const std::uint32_t type = number_at(bytes, 0), rows = number_at(bytes, 4), columns = number_at(bytes, 8);
  const std::uint32_t imaginary = number_at(bytes, 12), name_size = number_at(bytes, 16);
  if (type > 52 || type % 10 > 2 || rows == 0 || columns == 0 || imaginary > 1) return false;
  if (name_size < 2 || name_size > longest_name || bytes.size() < header + name_size) return false;
  const std::string_view name = bytes.substr(header, name_size - 1);
  const auto in_names = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return bytes[header + name_size - 1] == '\0' && std::all_of(name.begin(), name.end(), in_names);
}

// The text without a byte order mark. Whether it is text is looked at last, as that takes longest.
std::string_view unmarked(std::span<const std::byte> bytes) {
  return text_of(bytes).substr(byte_order_mark(bytes));
}

}  // namespace

bool begins_npy(std::span<const std::byte> bytes) {
  return text_of(bytes).starts_with(npy_magic);
}

bool begins_npz(std::span<const std::byte> bytes) {
  constexpr std::size_t name_size_at = 26, name_at = 30;
  const std::string_view text = text_of(bytes);
  if (!text.starts_with("PK\x03\x04")) return false;
  const std::size_t name_size = number_at(text, name_size_at) & 0xFFFF;
  return text.substr(std::min(name_at, text.size()), name_size).ends_with(".npy");
}

bool begins_mat(std::span<const std::byte> bytes) {
  const std::string_view text = text_of(bytes);
  return text.starts_with("MATLAB 5.0 MAT-file") || text.starts_with("MATLAB 7.3 MAT-file") || is_mat4(text);
}

bool begins_hdf5(std::span<const std::byte> bytes) {
  constexpr std::size_t first_block = 512, last_block = 8192;
  const std::string_view text = text_of(bytes);
  if (text.starts_with(hdf5_signature)) return true;
  for (std::size_t at = first_block; at <= last_block && at < text.size(); at *= 2) {
    if (text.substr(at).starts_with(hdf5_signature)) return true;
  }
  return false;
}

bool begins_netcdf(std::span<const std::byte> bytes) {
  const std::string_view text = text_of(bytes);
  return text.starts_with("CDF\x01") || text.starts_with("CDF\x02") || text.starts_with("CDF\x05");
}

bool begins_shapefile(std::span<const std::byte> bytes) {
  constexpr std::size_t version_at = 28;
  const std::string_view text = text_of(bytes);
  return text.starts_with("\0\0\x27\x0A"sv) && text.size() >= version_at + 4 &&
         text.substr(version_at, 4) == "\xE8\x03\0\0"sv;
}

bool begins_json(std::span<const std::byte> bytes) {
  const std::string_view first = beginning(unmarked(bytes));
  // A header line may name columns in brackets.
  const bool opens = first.starts_with('{') || first.starts_with('[');
  const std::string_view second = opens ? beginning(first.substr(1)) : std::string_view{};
  const std::string_view inside = first.starts_with('{') ? "\"}" : "[{\"-0123456789]";
  return !second.empty() && inside.find(second.front()) != std::string_view::npos && sniff(bytes) == Content::text;
}

bool begins_wkt(std::span<const std::byte> bytes) {
  return is_wkt(unmarked(bytes)) && sniff(bytes) == Content::text;
}

}  // namespace lober::detail
