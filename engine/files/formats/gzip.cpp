#include "engine/files/formats/gzip.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "engine/base/machine_memory.hpp"
#include "engine/files/formats/libraries.hpp"
#include "lober/base/error.hpp"
#if LOBER_HAS_ZLIB
#include <zlib.h>
#endif

namespace lober::detail {

bool is_gzip(std::span<const std::byte> bytes) {
  constexpr std::byte first{0x1F}, second{0x8B}, deflate{8};
  return bytes.size() >= 3 && bytes[0] == first && bytes[1] == second && bytes[2] == deflate;
}

#if LOBER_HAS_ZLIB
namespace {

struct Zlib {
  LOBER_LOADED(zlib_library, inflateInit2_);
  LOBER_LOADED(zlib_library, inflate);
  LOBER_LOADED(zlib_library, inflateReset);
  LOBER_LOADED(zlib_library, inflateEnd);
  LOBER_LOADED(zlib_library, compressBound);
  LOBER_LOADED(zlib_library, compress2);
};

const Zlib& zlib() {
  static const Zlib loaded;
  return loaded;
}

enum class Wrapping : std::uint8_t { zlib = 15, gzip = 16 + 15 };  // as inflateInit2 has it

// A stream of zlib, or of gzip members, that is read piece by piece.
class Inflater {
 public:
  Inflater(std::span<const std::byte> bytes, Wrapping wrapping) : rest_(bytes), wrapping_(wrapping) {
    if (zlib().inflateInit2_(&stream_, static_cast<int>(wrapping), ZLIB_VERSION, static_cast<int>(sizeof stream_)) !=
        Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { zlib().inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Fills `to`, or less at the end. Throws a text for bytes that are not what gzip writes.
  std::size_t read(std::span<std::byte> to) {
    stream_.next_out = reinterpret_cast<Bytef*>(to.data());
    stream_.avail_out = static_cast<uInt>(to.size());
    while (stream_.avail_out != 0 && !at_end_) step();
    return to.size() - stream_.avail_out;
  }

 private:
  void step() {
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    if (stream_.avail_in == 0) {
      const std::size_t size = std::min(rest_.size(), most);
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(rest_.data()));
      stream_.avail_in = static_cast<uInt>(size);
      rest_ = rest_.subspan(size);
    }
    const int status = zlib().inflate(&stream_, Z_NO_FLUSH);
    if (status == Z_STREAM_END) return begin_member();
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK) throw DataError(status == Z_BUF_ERROR ? "the file ends in the middle" : "it is damaged");
  }

  // Another member may follow, and zeros that fill a block of a tape.
  void begin_member() {
    if (wrapping_ == Wrapping::zlib || stream_.avail_in == 0 || *stream_.next_in == 0) {
      at_end_ = true;
    } else {
      zlib().inflateReset(&stream_);
    }
  }

  std::span<const std::byte> rest_;
  Wrapping wrapping_;
  z_stream stream_{};
  bool at_end_ = false;
};

}  // namespace

Buffer<std::byte> unzipped(const std::string& name, std::span<const std::byte> bytes) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  const auto fail = [&](const std::string& what) { throw DataError(name + ": is compressed by gzip: " + what); };
  if (!zlib_library.is_present()) fail(zlib_library.reason_it_is_missing());
  Buffer<std::byte> content;
  Inflater inflater(bytes, Wrapping::gzip);
  try {
    for (std::size_t used = 0;;) {
      if (used > memory_for_unknown_content()) fail("holds more than a quarter of this machine's memory");
      if (content.size() < used + piece) {
        Buffer<std::byte> larger(std::max({used + piece, 2 * content.size(), 4 * bytes.size()}));
        if (used != 0) std::memcpy(larger.data(), content.data(), used);
        content = std::move(larger);
      }
      const std::size_t got = inflater.read(std::span(content).subspan(used, piece));
      used += got;
      if (got < piece) {
        content.resize(used);
        return content;
      }
    }
  } catch (const DataError& error) {
    const std::string what = error.what();
    if (what.starts_with(name + ": ")) throw;
    fail(what);
  }
  return content;
}

std::optional<Buffer<std::byte>> inflated(std::span<const std::byte> bytes, std::size_t max_size) {
  if (!zlib_library.is_present()) return std::nullopt;
  Buffer<std::byte> content(max_size);
  content.resize(Inflater(bytes, Wrapping::zlib).read(content));
  return content;
}

std::optional<std::string> deflated(std::string_view bytes) {
  if (!zlib_library.is_present()) return std::nullopt;
  uLongf size = zlib().compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  const auto* const begin = reinterpret_cast<const Bytef*>(bytes.data());
  const int status = zlib().compress2(reinterpret_cast<Bytef*>(packed.data()), &size, begin,
                                      static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  if (status != Z_OK) throw std::bad_alloc();  // the only way in which it fails
  packed.resize(size);
  return packed;
}
#else
std::optional<Buffer<std::byte>> inflated(std::span<const std::byte>, std::size_t) {
  return std::nullopt;
}

std::optional<std::string> deflated(std::string_view) {
  return std::nullopt;
}

Buffer<std::byte> unzipped(const std::string& name, std::span<const std::byte>) {
  throw DataError(name + ": is compressed by gzip: " + zlib_library.reason_it_is_missing());
}
#endif

}  // namespace lober::detail
