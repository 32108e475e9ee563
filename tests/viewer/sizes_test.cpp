// How many bytes points take in pages: of curves as they are grown, and of worse ones. The table is printed.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/formats/gzip.hpp"
#include "lober/operations.hpp"
#include "viewer/base64.hpp"
#include "viewer/series.hpp"

namespace lober::viewer {
namespace {

constexpr std::size_t part = 65536;

struct Coordinates {
  std::vector<double> x, y;
};

// A branch of the vortex pair.
Coordinates grown(const std::string& side, double tolerance, double length) {
  const operations::Operation& operation = operations::named("grow");
  const std::vector<operations::OptionSetting> settings{{"side", side}, {"tolerance", tolerance}, {"length", length}};
  const std::array<operations::Input, 1> inputs{operations::system_input("ovp", {{"gamma", 0.5}, {"eps", 0.1}}, {})};
  const operations::Outcome outcome = operation.run(inputs, operations::Options(operation.options, settings), {});
  Coordinates found;
  for (const Point& point : outcome.as<operations::SystemManifold>().points) {
    found.x.push_back(point.x);
    found.y.push_back(point.y);
  }
  return found;
}

Coordinates noisy(std::size_t size, double noise) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0, noise);
  Coordinates found;
  for (std::size_t k = 0; k < size; ++k) {
    const double angle = 6.283 * static_cast<double>(k) / static_cast<double>(size);
    found.x.push_back(std::cos(angle) + normal(random));
    found.y.push_back(std::sin(angle) + normal(random));
  }
  return found;
}

double packed(const std::string& bytes) {
  const auto deflated = detail::deflated(bytes);
  return static_cast<double>(deflated ? deflated->size() : bytes.size());
}

// Third differences of multiples of `step` as zigzag numbers, byte by byte: the simpler form that this one is measured
// by.
std::string third_differences(std::span<const double> values, double step) {
  std::vector<std::int64_t> numbers;
  for (const double value : values) numbers.push_back(std::llround(value / step));
  for (int order = 0; order < 3; ++order) {
    for (std::size_t k = numbers.size(); k-- > 1;) numbers[k] -= numbers[k - 1];
  }
  std::string bytes;
  for (int plane = 0; plane < 8; ++plane) {
    for (const std::int64_t number : numbers) {
      const auto zigzag = static_cast<std::uint64_t>(number) << 1 ^ static_cast<std::uint64_t>(number >> 63);
      bytes += static_cast<char>(zigzag >> (8 * plane) & 0xff);
    }
  }
  return bytes;
}

struct Sizes {
  double heads = 0, first = 0, second = 0, rest = 0, deflated = 0, text = 0, differences = 0;  // bytes a point
};

Sizes sizes_of(const Coordinates& points, double step) {
  Sizes sum;
  const std::size_t size = points.x.size();
  for (std::size_t begin = 0; begin < size; begin += part) {
    const std::size_t count = std::min(part, size - begin);
    const std::span x = std::span(points.x).subspan(begin, count), y = std::span(points.y).subspan(begin, count);
    const std::string bytes = encode_points(x, y, step);
    const std::size_t heads = (count + series_block - 1) / series_block * 5;
    sum.heads += packed(bytes.substr(0, heads));
    sum.first += packed(bytes.substr(heads, count));
    sum.second += packed(bytes.substr(heads + count, count));
    sum.rest += packed(bytes.substr(heads + 2 * count));
    sum.deflated += packed(bytes);
    sum.text += std::ceil(packed(bytes) / 3) * 4;
    const double unit = step > 0 ? step : 0x1p-53;
    sum.differences += packed(third_differences(x, unit)) + packed(third_differences(y, unit));
  }
  for (double* const one :
       {&sum.heads, &sum.first, &sum.second, &sum.rest, &sum.deflated, &sum.text, &sum.differences}) {
    *one /= static_cast<double>(size);
  }
  return sum;
}

Sizes printed(const char* name, const Coordinates& points, double step) {
  const Sizes sizes = sizes_of(points, step);
  std::printf("%-34s %8zu %6.2f %7.2f %7.2f %6.2f %9.2f %6.2f %12.2f\n", name, points.x.size(), sizes.heads,
              sizes.first, sizes.second, sizes.rest, sizes.deflated, sizes.text, sizes.differences);
  return sizes;
}

TEST(PageSizes, OfCurves) {
  if (!detail::deflated("")) GTEST_SKIP() << "zlib is not there, so nothing is deflated";
  std::printf(
      "bytes a point, `text` as written     points  heads   first  second   bits  deflated   text  differences\n");
  // The curve is 6 units large.
  for (const auto& [name, side] : {std::pair{"U of the vortex pair", "unstable"}, {"S of the vortex pair", "stable"}}) {
    const Coordinates curve = grown(side, 1e-9, 25);
    const Sizes exact = printed((std::string(name) + ", exact").c_str(), curve, 0);
    EXPECT_LT(exact.deflated, 4.0);
    EXPECT_LT(exact.text, 5.2);  // as written
    const Sizes rounded = printed((std::string(name) + ", rounded").c_str(), curve, 0x1p-48);
    EXPECT_LT(rounded.deflated, 2.75);
    EXPECT_LT(rounded.text, 3.6);
    EXPECT_LT(rounded.deflated, 0.75 * rounded.differences);
  }
  EXPECT_LT(printed("circle with noise 1e-6, exact", noisy(200'000, 1e-6), 0).deflated, 9.5);
  EXPECT_LT(printed("circle with noise 1e-6, rounded", noisy(200'000, 1e-6), 0x1p-49).deflated, 8.5);
  const Sizes noise = printed("noise alone, exact", noisy(100'000, 1), 0);
  EXPECT_LT(noise.deflated, 16.5);
  EXPECT_LT(noise.text, 22.0);
}

}  // namespace
}  // namespace lober::viewer
