// Files of other formats are named, with a way out; raw numbers of another type are not read as float64.
#include <bit>
#include <cmath>
#include <numbers>
#include <random>

#include "curve_testing.hpp"
#include "engine/files/read_memory.hpp"

namespace lober::detail {
namespace {

using test::error_of;
using test::read;
using test::read_error;

using namespace std::string_literals;

TEST(Foreign, IsNamedWithAWayToConvert) {
  const std::string noise(600, '\x07');
  const std::vector<std::pair<std::string, const char*>> files{
      {"PK\x03\x04" + std::string(22, '\x01') + "\x05\0\0\0arr_0.npy"s + noise, "zip archive"},
      {std::string(257, '\0') + "ustar\00000"s + noise, "tar xf"},
      {"BZh9" + noise, "bzip2"},
      {"\xFD"s + "7zXZ\0"s + noise, "xz"},
      {"\x28\xB5\x2F\xFD" + noise, "zstd"},
      {"\x89PNG\r\n\x1A\n" + noise, "PNG"},
      {"\xFF\xD8\xFF\xE0" + noise, "JPEG"},
      {"%PDF-1.7\n" + noise, "PDF"},
      {"%PDF-1.7\n1 0 obj\n", "PDF"},
      {"PAR1" + noise, "Parquet"},
      {"ARROW1\0\0"s + noise, "Arrow"},
      {"\x80\x04\x95" + noise, "pickle"},
      {"SQLite format 3\0"s + noise, "lober batch export"},
      {"\x7F"
       "ELF" +
           noise,
       "library"},
      {"#!TDV112" + noise, "Tecplot"},
      {"\x10\0\0\0"s + std::string(16, '\x3F') + "\x10\0\0\0"s + noise, "Fortran"},
      {"\xFF\xFE\x31\0 \0\x32\0\n\0"s, "UTF-16"},
      {"\xFE\xFF\0\x31\0 \0\x32\0\n"s, "UTF-16"},
      {"<?xml version=\"1.0\"?><svg/>", "XML"},
      {"# vtk DataFile Version 3.0\nx\nASCII\n", "VTK"},
  };
  for (const auto& [bytes, words] : files) {
    const std::string message = read_error(bytes);
    EXPECT_TRUE(message.starts_with("in: this is ")) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message << " for " << words;
    EXPECT_NE(message.find("which is not read: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(Foreign, HeaderLinesInBracketsAreText) {
  for (const char* header : {"[m] [m]", "{x} {y}", "<x> <y>", "GRID"}) {
    EXPECT_EQ(read(std::string(header) + "\n1 2\n3 4\n5 7\n").zones.at(0).points.size(), 3U) << header;
  }
}

std::vector<Point> curve(std::size_t points, Point centre, double size) {
  std::vector<Point> result;
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    result.push_back({centre.x + size * std::cos(angle), centre.y + 0.7 * size * std::sin(angle + 0.3)});
  }
  return result;
}

template <typename Number>
std::string raw(const std::vector<Point>& points, bool swap = false) {
  std::string bytes;
  for (const Point& point : points) {
    for (const double coordinate : {point.x, point.y}) {
      const auto number = static_cast<Number>(coordinate);
      std::string one(reinterpret_cast<const char*>(&number), sizeof number);
      if (swap) std::reverse(one.begin(), one.end());
      bytes += one;
    }
  }
  return bytes;
}

// Also where every float32 begins like an ordinary float64: y in [1, 2).
TEST(RawNumbers, OfFloat32AreNotReadAsFloat64) {
  for (const Point centre : {Point{0, 0}, Point{1.5, 1.4}, Point{-300, 4000}, Point{12345.6, 0.01}}) {
    for (const double size : {0.25, 3.0, 100.0}) {
      const std::string message = read_error(raw<float>(curve(1000, centre, size)));
      EXPECT_NE(message.find("float32"), std::string::npos) << centre.x << ' ' << size << ": " << message;
      EXPECT_NE(message.find(".f64"), std::string::npos) << message;
    }
  }
}

// Few of them, and in no order.
TEST(RawNumbers, OfFloat32WithoutACurveAreNotReadAsFloat64) {
  std::mt19937_64 random(11);
  for (const std::size_t points : {8UL, 12UL, 30UL, 34UL, 1000UL}) {
    for (const double size : {0.01, 1.0, 90.0, 5000.0}) {
      for (int repeat = 0; repeat < 50; ++repeat) {
        std::uniform_real_distribution<double> uniform(-size, size);
        std::vector<Point> all(points);
        for (Point& point : all) point = {uniform(random), uniform(random)};
        const std::string message = read_error(raw<float>(all));
        EXPECT_NE(message.find("float32"), std::string::npos) << points << ' ' << size << ": " << message;
      }
    }
  }
}

// Corners of boxes, decimals of few digits, thirds, steps, random numbers: in files of any length.
TEST(RawNumbers, OfFloat64InShortFilesAreRead) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (std::size_t points = 3; points < 60; ++points) {
    for (int kind = 0; kind < 40; ++kind) {
      std::vector<Point> all;
      for (std::size_t k = 0; k < points; ++k) {
        const auto t = static_cast<double>(k);
        switch (kind) {
          case 0:
            all.push_back({0.1 * t, 0.7 - 0.1 * t});
            break;
          case 1:
            all.push_back({t / 3, 1 - t / 7});
            break;
          case 2:
            all.push_back({t, static_cast<double>(k * k)});
            break;
          case 3:
            all.push_back({0.7 * std::exp2(t), 0.7});
            break;
          case 4:
            all.push_back({1 + t * 0x1p-30, 1.25 + t * 0x1p-29});
            break;
          case 5:
            all.push_back({double{static_cast<float>(uniform(random))}, double{static_cast<float>(uniform(random))}});
            break;
          default:
            all.push_back({uniform(random), std::ldexp(uniform(random), kind - 20)});
        }
      }
      EXPECT_TRUE(test::same_bits(read(raw<double>(all)).zones.at(0).points, all)) << points << ' ' << kind;
    }
  }
}

TEST(RawNumbers, OfAnotherByteOrderOrTypeAreNotReadAsFloat64) {
  const std::string swapped = read_error(raw<double>(curve(1000, {0.3, 0.2}, 1), true));
  EXPECT_NE(swapped.find("other byte order"), std::string::npos) << swapped;
  const std::string whole = read_error(raw<std::int64_t>(curve(1000, {0, 0}, 1e6)));
  EXPECT_NE(whole.find("something else"), std::string::npos) << whole;
  const std::string half = read_error(raw<std::int32_t>(curve(1000, {0, 0}, 1e6)));
  EXPECT_NE(half.find("something else"), std::string::npos) << half;
}

TEST(RawNumbers, OfFloat64AreRead) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<std::vector<Point>> curves;
  for (const std::size_t points : {3UL, 31UL, 32UL, 100UL, 10000UL}) {
    for (const double size : {1e-30, 1e-3, 1.0, 1e20}) {
      curves.push_back(curve(points, {0, 0}, size));
      curves.push_back(curve(points, {size * 1e6, -size}, size));
    }
  }
  // Numbers of few digits, of float32, and noise.
  curves.push_back({});
  for (int k = 0; k < 5000; ++k) curves.back().push_back({k / 1024.0, (k * k % 4096) / 8.0});
  curves.push_back(curve(5000, {0.1, 0.2}, 1));
  for (Point& point : curves.back()) point = {double{static_cast<float>(point.x)}, double{static_cast<float>(point.y)}};
  curves.push_back({});
  for (int k = 0; k < 5000; ++k) curves.back().push_back({uniform(random), uniform(random)});
  // A steady step whose low bits count up.
  curves.push_back({});
  for (int k = 0; k < 5000; ++k) curves.back().push_back({1 + k * 0x1p-40, 2 + k * 0x1p-41});
  // A manifold that begins at a saddle at the origin.
  curves.push_back({});
  for (int k = 0; k < 4000; ++k) {
    const double s = std::exp(0.02 * (k - 3500));
    curves.back().push_back({s, 0.1 * s * s});
  }
  for (const std::vector<Point>& points : curves) {
    const CurveFile file = read(raw<double>(points));
    ASSERT_EQ(file.format, Format::raw);
    EXPECT_TRUE(test::same_bits(file.zones.at(0).points, points));
  }
}

TEST(RawNumbers, AreTakenAtTheirWordByName) {
  const std::string bytes = raw<float>(curve(1000, {1.5, 1.5}, 0.25));
  const CurveFile file = read_curve_bytes("x.f64", std::as_bytes(std::span(bytes)));
  EXPECT_EQ(file.format, Format::raw);
  EXPECT_EQ(file.zones.at(0).points.size(), 500U);
}

}  // namespace
}  // namespace lober::detail
