// ESRI shapefiles, the .shp alone. Shapelib reads it, from memory; the index that it wants beside it follows from the
// records.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>

#include "engine/files/byte_order.hpp"
#include "engine/files/formats/geometry_zones.hpp"
#include "engine/files/formats/libraries.hpp"
#include "engine/files/formats/readers.hpp"
#include "lober/base/error.hpp"
#if LOBER_HAS_SHAPELIB
#include <shapefil.h>
#endif

namespace lober::detail {

#if LOBER_HAS_SHAPELIB
namespace {

struct Shapelib {
  LOBER_LOADED(shapelib_library, SHPOpenLL);
  LOBER_LOADED(shapelib_library, SHPClose);
  LOBER_LOADED(shapelib_library, SHPGetInfo);
  LOBER_LOADED(shapelib_library, SHPReadObject);
  LOBER_LOADED(shapelib_library, SHPDestroyObject);
};

const Shapelib& shapelib() {
  static const Shapelib loaded;
  return loaded;
}

constexpr std::size_t shape_head = 100, record_head = 8;  // bytes

std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes.data() + at, sizeof bits);
  return reversed_bytes(bits);
}

void append_big_endian(std::vector<std::byte>& bytes, std::size_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(value >> shift & 0xFF));
}

// The .shx file: the head of the .shp with its own length, then the place and length of each record, in words of two
// bytes.
std::vector<std::byte> index_of(std::span<const std::byte> bytes, const std::string& path) {
  constexpr std::size_t length_at = 24, word = 2;
  if (bytes.size() < shape_head) throw DataError(path + ": is a shapefile that ends in its head");
  std::vector<std::byte> index(bytes.begin(), bytes.begin() + shape_head);
  std::size_t records = 0;
  for (std::size_t at = shape_head; at < bytes.size(); ++records) {
    const std::size_t length = bytes.size() - at < record_head ? bytes.size() : word * big_endian(bytes, at + 4);
    if (length > bytes.size() - at - std::min(record_head, bytes.size() - at)) {
      throw DataError(path + ": record " + std::to_string(records) + " of the shapefile goes on behind its end");
    }
    append_big_endian(index, at / word);
    append_big_endian(index, length / word);
    at += record_head + length;
  }
  std::vector<std::byte> length;
  append_big_endian(length, index.size() / word);
  std::copy(length.begin(), length.end(), index.begin() + length_at);
  return index;
}

// An open file of the library: bytes and a position in them.
struct Stream {
  std::span<const std::byte> bytes;
  std::size_t at = 0;
};

// The two files that it may open. Its hooks carry nothing of ours; only one thread at a time works with it.
struct Files {
  std::span<const std::byte> shapes, index;
};
const Files* open_files = nullptr;

Stream& stream_of(SAFile file) {
  return *reinterpret_cast<Stream*>(file);
}

SAFile open_stream(const char* name, const char*) {
  const std::string_view path(name);
  if (path.ends_with(".shp")) return reinterpret_cast<SAFile>(new Stream{open_files->shapes});
  if (path.ends_with(".shx")) return reinterpret_cast<SAFile>(new Stream{open_files->index});
  return nullptr;
}

SAOffset read_stream(void* to, SAOffset size, SAOffset count, SAFile file) {
  Stream& stream = stream_of(file);
  if (size == 0 || stream.at > stream.bytes.size()) return 0;
  const std::size_t whole = std::min<std::size_t>(count, (stream.bytes.size() - stream.at) / size);
  if (whole != 0) std::memcpy(to, stream.bytes.data() + stream.at, whole * size);
  stream.at += whole * size;
  return whole;
}

SAOffset seek_stream(SAFile file, SAOffset offset, int whence) {
  Stream& stream = stream_of(file);
  stream.at = offset + (whence == SEEK_CUR ? stream.at : whence == SEEK_END ? stream.bytes.size() : 0);
  return 0;
}

int close_stream(SAFile file) {
  delete &stream_of(file);
  return 0;
}

SAHooks hooks() {
  SAHooks hooks{};
  hooks.FOpen = open_stream;
  hooks.FRead = read_stream;
  hooks.FWrite = [](void*, SAOffset, SAOffset, SAFile) -> SAOffset { return 0; };
  hooks.FSeek = seek_stream;
  hooks.FTell = [](SAFile file) -> SAOffset { return stream_of(file).at; };
  hooks.FFlush = [](SAFile) { return 0; };
  hooks.FClose = close_stream;
  hooks.Remove = [](const char*) { return -1; };
  hooks.Error = [](const char*) {};
  hooks.Atof = [](const char*) { return 0.0; };
  return hooks;
}

// Twice the signed area, which tells a polygon's holes from its outer rings: holes turn counter-clockwise.
bool is_counter_clockwise(const std::vector<Point>& ring) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
    sum +=
        (ring[k].x - ring[0].x) * (ring[k + 1].y - ring[0].y) - (ring[k + 1].x - ring[0].x) * (ring[k].y - ring[0].y);
  }
  return sum > 0;
}

void add_shape(const SHPObject& shape, GeometryZones& zones, const std::string& name) {
  const auto vertices = static_cast<std::size_t>(std::max(shape.nVertices, 0));
  const auto point = [&](std::size_t k) { return Point{shape.padfX[k], shape.padfY[k]}; };
  if (shape.nSHPType == SHPT_POINT || shape.nSHPType == SHPT_POINTZ || shape.nSHPType == SHPT_POINTM) {
    if (vertices > 0) zones.add_point(point(0));
    return;
  }
  const bool is_polygon =
      shape.nSHPType == SHPT_POLYGON || shape.nSHPType == SHPT_POLYGONZ || shape.nSHPType == SHPT_POLYGONM;
  const std::size_t first = zones.size(), parts = static_cast<std::size_t>(std::max(shape.nParts, 1));
  for (std::size_t part = 0; part < parts; ++part) {
    const auto start = [&](std::size_t k) {
      return k < parts && shape.nParts > 0 ? static_cast<std::size_t>(shape.panPartStart[k]) : k == 0 ? 0 : vertices;
    };
    std::vector<Point> points;
    for (std::size_t k = start(part); k < std::min(start(part + 1), vertices); ++k) points.push_back(point(k));
    const bool hole = is_polygon && part > 0 && is_counter_clockwise(points);
    zones.add_line(std::move(points), hole);
  }
  zones.name_from(first, name);
}

}  // namespace

void read_shapefile(const FileSource& source, CurveFile& file) {
  if (!shapelib_library.is_present()) {
    throw DataError(file.path + ": this is a shapefile, " + shapelib_library.reason_it_is_missing());
  }
  const std::vector<std::byte> index = index_of(source.bytes, file.path);
  const std::lock_guard lock(one_thread_at_a_time());
  const Files files{source.bytes, index};
  open_files = &files;
  SAHooks with_memory = hooks();
  const std::unique_ptr<SHPInfo, void (*)(SHPHandle)> shapes(shapelib().SHPOpenLL("image.shp", "rb", &with_memory),
                                                             shapelib().SHPClose);
  if (shapes == nullptr) throw DataError(file.path + ": is a shapefile that is damaged");
  int count = 0;
  shapelib().SHPGetInfo(shapes.get(), &count, nullptr, nullptr, nullptr);
  GeometryZones zones(file);
  for (int k = 0; k < count; ++k) {
    const std::unique_ptr<SHPObject, void (*)(SHPObject*)> shape(shapelib().SHPReadObject(shapes.get(), k),
                                                                 shapelib().SHPDestroyObject);
    if (shape == nullptr) throw DataError(file.path + ": record " + std::to_string(k) + " of the shapefile is damaged");
    add_shape(*shape, zones, "shape " + std::to_string(k));
  }
  zones.finish();
}
#else
void read_shapefile(const FileSource&, CurveFile& file) {
  throw DataError(file.path + ": this is a shapefile, " + shapelib_library.reason_it_is_missing());
}
#endif

}  // namespace lober::detail
