// The NPY format, as NumPy's documentation of numpy.lib.format describes it: magic string, version, length of
// the header, a Python dictionary {'descr': '<f8', 'fortran_order': False, 'shape': (N, 2)}, then the
// numbers.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#include "engine/base/parallel/parallel.hpp"
#include "engine/files/binary_file.hpp"
#include "engine/files/text_points.hpp"

namespace lober::detail {
namespace {

struct Header {
  std::optional<std::string> descr;
  std::optional<bool> fortran_order;
  std::optional<std::vector<std::size_t>> shape;
};

/// Reads the dictionary; whatever it is not made of is an error.
class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

  Header parse() {
    Header header;
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

/// How the numbers lie in the file.
struct Layout {
  std::size_t points = 0;
  std::size_t item = 8;      ///< bytes of a number
  bool swap = false;         ///< whether the byte order is the other one
  bool interleaved = false;  ///< x y x y ..., otherwise all x, then all y
};

Layout layout_of(const Header& header, const std::string& path) {
  const std::string_view type = *header.descr;
  constexpr bool little = std::endian::native == std::endian::little;
  const bool known = type.size() == 3 && (type.ends_with("f8") || type.ends_with("f4")) &&
                     std::string_view("<>=").find(type.front()) != std::string_view::npos;
  if (!known) throw DataError(path + ": element type " + quoted_text(type) + ": expected <f8, >f8, <f4 or >f4");
  const std::vector<std::size_t>& shape = *header.shape;
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
  layout.interleaved = rows != *header.fortran_order;
  return layout;
}

template <typename Unsigned>
constexpr Unsigned reversed(Unsigned value) {
  Unsigned result = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    result = static_cast<Unsigned>(result << 8) | (value & 0xFF);
    value = static_cast<Unsigned>(value >> 8);
  }
  return result;
}

template <typename Float, typename Unsigned>
double load(const std::byte* from, bool swap) {
  Unsigned bits = 0;
  std::memcpy(&bits, from, sizeof bits);
  return static_cast<double>(std::bit_cast<Float>(swap ? reversed(bits) : bits));
}

template <typename Float, typename Unsigned>
void convert(const std::byte* data, const Layout& layout, std::span<Point> points) {
  constexpr std::size_t grain = std::size_t{1} << 16;
  const std::size_t step = layout.interleaved ? 2 * sizeof(Float) : sizeof(Float);
  const std::byte* const ys = data + (layout.interleaved ? 1 : layout.points) * sizeof(Float);
  for_each_block(layout.points, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points[i] = {load<Float, Unsigned>(data + i * step, layout.swap),
                   load<Float, Unsigned>(ys + i * step, layout.swap)};
    }
  });
}

}  // namespace

void read_npy(std::span<const std::byte> bytes, CurveFile& file) {
  file.format = Format::npy;
  const auto fail = [&](const std::string& message) { throw DataError(file.path + ": " + message); };
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
  const Layout layout = layout_of(HeaderParser(text, file.path).parse(), file.path);

  const std::span<const std::byte> data = rest.subspan(header_size);
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
