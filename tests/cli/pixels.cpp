#include "tests/cli/pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "engine/files/formats/optional_library.hpp"

namespace lober::cli {
namespace {

constexpr int rgb24 = 1;  // CAIRO_FORMAT_RGB24
constexpr std::size_t square = 8, square_step = 4;
constexpr int square_tolerance = 11;  // of 255
constexpr detail::OptionalLibrary cairo("libcairo.so.2", "libcairo2", "libcairo2");

using Release = void (*)(void*);
using Surface = std::unique_ptr<void, Release>;

Surface held(void* surface) {
  return {surface, cairo.function<Release>("cairo_surface_destroy")};
}

template <typename Result>
Result value_of(const char* name, void* surface) {
  return cairo.function<Result (*)(void*)>(name)(surface);
}

struct Source {
  const std::string& bytes;
  std::size_t next = 0;
};

int read_bytes(void* closure, unsigned char* data, unsigned length) noexcept {
  auto& source = *static_cast<Source*>(closure);
  if (length > source.bytes.size() - source.next) return 10;  // CAIRO_STATUS_READ_ERROR
  std::memcpy(data, source.bytes.data() + source.next, length);
  source.next += length;
  return 0;
}

int append_bytes(void* closure, const unsigned char* data, unsigned length) noexcept {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return 0;
}

// The nearest of sixteen values.
std::uint8_t stepped(std::uint8_t value) {
  return static_cast<std::uint8_t>(std::round(std::round(value / 255.0 * 15) * 255.0 / 15));
}

std::array<int, 3> mean_of(const Pixels& pixels, std::size_t x0, std::size_t y0) {
  std::array<int, 3> sum{};
  for (std::size_t y = y0; y < y0 + square; ++y) {
    for (std::size_t x = x0; x < x0 + square; ++x) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pixels.at(x, y)[c];
    }
  }
  for (int& one : sum) one /= static_cast<int>(square * square);
  return sum;
}

}  // namespace

Pixels pixels_of_png(const std::string& bytes) {
  Source source{bytes};
  using FromStream = void* (*)(int (*)(void*, unsigned char*, unsigned), void*);
  const Surface surface =
      held(cairo.function<FromStream>("cairo_image_surface_create_from_png_stream")(&read_bytes, &source));
  if (value_of<int>("cairo_surface_status", surface.get()) != 0) throw std::runtime_error("the PNG cannot be read");
  Pixels pixels;
  pixels.width = static_cast<std::size_t>(value_of<int>("cairo_image_surface_get_width", surface.get()));
  pixels.height = static_cast<std::size_t>(value_of<int>("cairo_image_surface_get_height", surface.get()));
  const auto stride = static_cast<std::size_t>(value_of<int>("cairo_image_surface_get_stride", surface.get()));
  const auto* const data = value_of<unsigned char*>("cairo_image_surface_get_data", surface.get());
  for (std::size_t y = 0; y < pixels.height; ++y) {
    for (std::size_t x = 0; x < pixels.width; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, data + y * stride + 4 * x, 4);
      pixels.colours.push_back({static_cast<std::uint8_t>(word >> 16U), static_cast<std::uint8_t>(word >> 8U),
                                static_cast<std::uint8_t>(word)});
    }
  }
  return pixels;
}

std::string small_png_of(const Pixels& pixels) {
  using Create = void* (*)(int, int, int);
  const Surface surface = held(cairo.function<Create>("cairo_image_surface_create")(
      rgb24, static_cast<int>(pixels.width), static_cast<int>(pixels.height)));
  const auto stride = static_cast<std::size_t>(value_of<int>("cairo_image_surface_get_stride", surface.get()));
  auto* const data = value_of<unsigned char*>("cairo_image_surface_get_data", surface.get());
  for (std::size_t y = 0; y < pixels.height; ++y) {
    for (std::size_t x = 0; x < pixels.width; ++x) {
      std::uint32_t word = 0;
      for (const std::uint8_t value : pixels.at(x, y)) word = word << 8U | stepped(value);
      std::memcpy(data + y * stride + 4 * x, &word, 4);
    }
  }
  cairo.function<Release>("cairo_surface_mark_dirty")(surface.get());
  std::string bytes;
  using Write = int (*)(void*, int (*)(void*, const unsigned char*, unsigned), void*);
  if (cairo.function<Write>("cairo_surface_write_to_png_stream")(surface.get(), &append_bytes, &bytes) != 0) {
    throw std::runtime_error("the PNG cannot be written");
  }
  return bytes;
}

std::size_t differing_squares(const Pixels& a, const Pixels& b) {
  if (a.width != b.width || a.height != b.height) return a.width * a.height;
  std::size_t count = 0;
  for (std::size_t y = 0; y + square <= a.height; y += square_step) {
    for (std::size_t x = 0; x + square <= a.width; x += square_step) {
      const std::array<int, 3> first = mean_of(a, x, y), second = mean_of(b, x, y);
      bool differs = false;
      for (std::size_t c = 0; c < 3; ++c) differs |= std::abs(first[c] - second[c]) > square_tolerance;
      count += differs ? 1 : 0;
    }
  }
  return count;
}

std::size_t differing_pixels(const Pixels& a, const Pixels& b) {
  if (a.width != b.width || a.height != b.height) return a.width * a.height;
  std::size_t count = 0;
  for (std::size_t k = 0; k < a.colours.size(); ++k) {
    bool differs = false;
    for (std::size_t c = 0; c < 3; ++c) differs |= std::abs(a.colours[k][c] - b.colours[k][c]) > 64;
    count += differs ? 1 : 0;
  }
  return count;
}

}  // namespace lober::cli
