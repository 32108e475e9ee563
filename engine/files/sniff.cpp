#include "engine/files/sniff.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "engine/files/tecplot.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t sniffed = 4096;

std::string_view text_in(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// White space, from the tabulator to the carriage return, aside.
bool is_control(unsigned char c) {
  return (c < 0x20 && (c < '\t' || c > '\r')) || c == 0x7F;
}

/// Every lead byte is followed by as many continuation bytes as it announces; the last character may be cut
/// off.
bool looks_like_utf8(std::string_view text) {
  int expected = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continuation = (byte & 0xC0) == 0x80;
    if (continuation != (expected > 0)) return false;
    if (continuation) {
      --expected;
    } else if (byte >= 0xC0) {
      expected = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
    }
  }
  return true;
}

bool is_text(std::string_view head) {
  const std::string_view first = head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  if (tecplot_record(first.substr(0, first.find('\n'))) != TecplotRecord::none) return true;
  // To the end in any case, so that the compiler can take many at a time: a batch reads thousands of small files.
  std::size_t control = 0, high = 0;
  for (const char c : head) {
    const auto byte = static_cast<unsigned char>(c);
    control += static_cast<std::size_t>(is_control(byte));
    high += static_cast<std::size_t>(byte >= 0x80);
  }
  return control == 0 && (high <= head.size() / 4 || looks_like_utf8(head));
}

}  // namespace

std::size_t byte_order_mark(std::span<const std::byte> bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text_in(bytes).starts_with(mark) ? mark.size() : 0;
}

Content sniff(std::span<const std::byte> bytes) {
  const std::span<const std::byte> head = bytes.first(std::min(bytes.size(), sniffed));
  if (text_in(head).starts_with("\x93NUMPY")) return Content::npy;
  return is_text(text_in(head.subspan(byte_order_mark(head)))) ? Content::text : Content::raw;
}

}  // namespace lober::detail

namespace lober {

bool begins_as_text(const std::string& path) {
  std::string head(detail::sniffed, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return !head.empty() && detail::sniff(std::as_bytes(std::span(head))) == detail::Content::text;
}

}  // namespace lober
