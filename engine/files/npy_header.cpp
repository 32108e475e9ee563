// The NPY format, as NumPy's documentation of numpy.lib.format describes it: magic string, version, length of
// the header, a Python dictionary {'descr': '<f8', 'fortran_order': False, 'shape': (N, 2)}, then the
// numbers.
#include "engine/files/npy_header.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>
#include <utility>

#include "engine/files/text_points.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

struct Dictionary {
  std::optional<std::string> descr;
  std::optional<bool> fortran_order;
  std::optional<std::vector<std::size_t>> shape;
};

/// Reads the dictionary; whatever it is not made of is an error.
class NpyHeaderParser {
 public:
  NpyHeaderParser(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

  Dictionary parse() {
    Dictionary header;
    expect('{');
    while (!take('}')) {
      const std::string key = string();
      expect(':');
      if (key == "descr") {
        header.descr = descr();
      } else if (key == "fortran_order") {
        header.fortran_order = boolean();
      } else if (key == "shape") {
        header.shape = tuple();
      } else {
        fail("unknown key " + quoted_text(key));
      }
      if (!take(',')) {
        expect('}');
        break;
      }
    }
    skip_blanks();
    if (!rest_.empty()) fail("characters after the closing brace");
    if (!header.descr || !header.fortran_order || !header.shape) {
      fail("expected descr, fortran_order and shape");
    }
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw DataError(path_ + ": NPY header: " + reason); }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }

  bool take(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(std::string("expected '") + c + "' before " + quoted_text(rest_));
  }

  std::string string() {
    const char mark = take('\'') ? '\'' : '"';
    if (mark == '"') expect('"');
    const std::size_t end = rest_.find(mark);
    if (end == std::string_view::npos) fail("unterminated string");
    std::string result(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return result;
  }

  std::string descr() {
    skip_blanks();
    if (rest_.starts_with('[')) fail("structured arrays are not supported");
    return string();
  }

  bool boolean() {
    skip_blanks();
    for (const bool value : {false, true}) {
      const std::string_view word = value ? "True" : "False";
      if (!rest_.starts_with(word)) continue;
      rest_.remove_prefix(word.size());
      return value;
    }
    fail("expected True or False before " + quoted_text(rest_));
  }

  std::vector<std::size_t> tuple() {
    std::vector<std::size_t> sizes;
    expect('(');
    while (!take(')')) {
      skip_blanks();
      std::size_t size = 0;
      const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), size);
      if (error != std::errc{}) fail("expected a size before " + quoted_text(rest_));
      rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
      sizes.push_back(size);
      if (!take(',')) {
        expect(')');
        break;
      }
    }
    return sizes;
  }

  std::string_view rest_;
  const std::string& path_;
};

}  // namespace

NpyHeader read_npy_header(std::span<const std::byte> bytes, const std::string& path) {
  const auto fail = [&](const std::string& message) { throw DataError(path + ": " + message); };
  constexpr std::size_t version_at = 6;  // after the magic string
  constexpr std::size_t length_at = 8;
  const unsigned version = bytes.size() > version_at ? std::to_integer<unsigned>(bytes[version_at]) : 0;
  if (version < 1 || version > 3) fail("NPY version " + std::to_string(version) + " is not supported");
  const std::size_t length_size = version == 1 ? 2 : 4;
  if (bytes.size() < length_at + length_size) fail("NPY header: the file ends in it");
  std::size_t header_size = 0;
  for (std::size_t i = length_size; i-- > 0;) {
    header_size = header_size << 8 | std::to_integer<std::size_t>(bytes[length_at + i]);
  }
  const std::span<const std::byte> rest = bytes.subspan(length_at + length_size);
  if (rest.size() < header_size) fail("NPY header: the file ends in it");
  const std::string_view text(reinterpret_cast<const char*>(rest.data()), header_size);
  Dictionary found = NpyHeaderParser(text, path).parse();
  return {std::move(*found.descr), *found.fortran_order, std::move(*found.shape),
          length_at + length_size + header_size};
}

std::string npy_head(std::span<const std::size_t> shape, std::string_view type) {
  constexpr std::size_t before_header = 10;  // magic string, version, length of the header
  constexpr std::size_t alignment = 64;
  const char order = std::endian::native == std::endian::little ? '<' : '>';
  std::string header = std::string("{'descr': '") + order + std::string(type) + "', 'fortran_order': False, 'shape': (";
  for (const std::size_t& size : shape) header += std::to_string(size) + (&size == &shape.back() ? "" : ", ");
  header += shape.size() == 1 ? ",), }" : "), }";
  const std::size_t unpadded = before_header + header.size() + 1;
  header.append((alignment - unpadded % alignment) % alignment, ' ');
  header += '\n';
  // Version 1.0; the length has two bytes, the low one first.
  std::string head("\x93NUMPY\x01\x00", 8);
  head += static_cast<char>(header.size() & 0xFF);
  head += static_cast<char>(header.size() >> 8);
  return head + header;
}

}  // namespace lober::detail
