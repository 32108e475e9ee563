// NPY and raw files: every layout, every lie in a header.
#include <algorithm>
#include <limits>

#include "curve_testing.hpp"
#include "lober/curve/files.hpp"

namespace lober {
namespace {

using test::read;
using test::read_error;

const std::vector<Point> binary_points{{1.5, -2.25}, {3, 4}, {-5.125, 1024}};

/// Bytes of a number as the element type says.
template <typename Float>
std::string element(double value, bool big_endian) {
  const auto number = static_cast<Float>(value);
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string npy(const std::string& header, const std::string& data, int version = 1) {
  std::string text = "\x93NUMPY";
  text += static_cast<char>(version);
  text += '\0';
  for (int i = 0; i < (version == 1 ? 2 : 4); ++i) text += static_cast<char>(header.size() >> (8 * i) & 0xFF);
  return text + header + data;
}

std::string header_of(const std::string& descr, bool fortran, const std::string& shape) {
  return "{'descr': '" + descr + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape +
         ", }\n";
}

std::string data_of(const std::string& descr, bool interleaved, std::span<const Point> points) {
  std::string data;
  const auto add = [&](double value) {
    data += descr[2] == '8' ? element<double>(value, descr[0] == '>') : element<float>(value, descr[0] == '>');
  };
  if (interleaved) {
    for (const Point& point : points) {
      add(point.x);
      add(point.y);
    }
  } else {
    for (const Point& point : points) add(point.x);
    for (const Point& point : points) add(point.y);
  }
  return data;
}

TEST(Npy, ReadsEveryTypeOrderShapeAndVersion) {
  for (const std::string descr : {"<f8", ">f8", "=f8", "<f4", ">f4", "=f4"}) {
    for (const bool fortran : {false, true}) {
      for (const bool rows : {false, true}) {
        for (const int version : {1, 2, 3}) {
          const CurveFile file = read(npy(header_of(descr, fortran, rows ? "(3, 2)" : "(2, 3)"),
                                          data_of(descr, rows != fortran, binary_points), version));
          EXPECT_EQ(file.format, Format::npy);
          ASSERT_EQ(file.zones.size(), 1U);
          EXPECT_EQ(file.zones[0].points, binary_points) << descr << fortran << rows << version;
        }
      }
    }
  }
}

TEST(Npy, TwoByTwoIsOnePointARow) {
  const std::span<const Point> two = std::span(binary_points).first(2);
  EXPECT_EQ(read(npy(header_of("<f8", false, "(2, 2)"), data_of("<f8", true, two))).zones[0].points,
            std::vector<Point>(two.begin(), two.end()));
}

TEST(Npy, ReadsHeadersThatAreWrittenOtherwise) {
  const std::string data = data_of("<f8", true, binary_points);
  for (const std::string header : {"{\"shape\":(3,2),\"descr\":\"<f8\",\"fortran_order\":False}",
                                   "{ 'fortran_order' : False , 'descr' : '<f8' , 'shape' : ( 3 , 2 , ) }  \n",
                                   "{\n'descr':'<f8','fortran_order':False,'shape':(3,2),}"}) {
    EXPECT_EQ(read(npy(header, data)).zones[0].points, binary_points) << header;
  }
}

TEST(Npy, RefusesWhatItCannotRead) {
  const std::string data = data_of("<f8", true, binary_points);
  const auto error = [&](const std::string& header) { return read_error(npy(header, data)); };
  EXPECT_EQ(error(header_of("|S8", false, "(3, 2)")),
            "in: element type \"|S8\": expected numbers, such as <f8, >f4, <i4 or <c16");
  EXPECT_EQ(error(header_of("|f8", false, "(3, 2)")),
            "in: element type \"|f8\": expected numbers, such as <f8, >f4, <i4 or <c16");
  EXPECT_EQ(error(header_of("<c16", false, "(3, 2)")), "in: shape (3, 2) of complex numbers: expected (N,)");
  EXPECT_EQ(error("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (3,)}"),
            "in: NPY header: structured arrays are not supported");
  EXPECT_EQ(error(header_of("<f8", false, "(6,)")), "in: shape (6): expected (N, 2) or (2, N)");
  EXPECT_EQ(error(header_of("<f8", false, "(3, 3)")), "in: shape (3, 3): expected (N, 2) or (2, N)");
  EXPECT_EQ(error(header_of("<f8", false, "()")), "in: shape (): expected (N, 2) or (2, N)");
  EXPECT_EQ(error(header_of("<f8", false, "(3, 2, 1)")), "in: shape (3, 2, 1): expected (N, 2) or (2, N)");
  EXPECT_EQ(error(header_of("<f8", false, "(4, 2)")),
            "in: the NPY header promises 4 points of 16 bytes, the file has 48 bytes for them");
  EXPECT_EQ(error(header_of("<f8", false, "(2, 2)")),
            "in: the NPY header promises 2 points of 16 bytes, the file has 48 bytes for them");
  EXPECT_EQ(error(header_of("<f8", false, "(1152921504606846979, 2)")),
            "in: the NPY header promises 1152921504606846979 points of 16 bytes, the file has 48 bytes for them");
  EXPECT_EQ(error(header_of("<f8", false, "(99999999999999999999, 2)")),
            "in: NPY header: expected a size before \"99999999999999999999, 2), }?\"");
  EXPECT_EQ(error(header_of("<f8", false, "(-3, 2)")), "in: NPY header: expected a size before \"-3, 2), }?\"");
  EXPECT_EQ(error("{}"), "in: NPY header: expected descr, fortran_order and shape");
  EXPECT_EQ(error(""), "in: NPY header: expected '{' before \"\"");
  EXPECT_EQ(error("{'descr': '<f8"), "in: NPY header: unterminated string");
  EXPECT_EQ(error("{'color': 'red'}"), "in: NPY header: unknown key \"color\"");
  EXPECT_EQ(error("{'descr': '<f8', 'fortran_order': Maybe}"),
            "in: NPY header: expected True or False before \"Maybe}\"");
  EXPECT_EQ(read_error(npy(header_of("<f8", false, "(0, 2)"), "")), "in: no points");
}

// Integers, halves and complex numbers, in either order.
TEST(Npy, ReadsOtherNumbers) {
  const std::vector<Point> expected{{1, -2}, {3, 4}, {0, 7}};
  const auto bytes = [](std::initializer_list<int> all) {
    std::string text;
    for (const int one : all) text += static_cast<char>(one);
    return text;
  };
  const auto points = [](const std::string& file) { return read(file).zones.at(0).points; };
  EXPECT_EQ(points(npy(header_of("|i1", false, "(3, 2)"), bytes({1, -2, 3, 4, 0, 7}))), expected);
  EXPECT_EQ(points(npy(header_of("<i2", true, "(3, 2)"), bytes({1, 0, 3, 0, 0, 0, -2, -1, 4, 0, 7, 0}))), expected);
  EXPECT_EQ(points(npy(header_of(">i2", false, "(2, 3)"), bytes({0, 1, 0, 3, 0, 0, -1, -2, 0, 4, 0, 7}))), expected);
  EXPECT_EQ(points(npy(header_of("<f2", false, "(3, 2)"), bytes({0, 0x3C, 0, 0xC0, 0, 0x42, 0, 0x44, 0, 0, 0, 0x47}))),
            expected);
  for (const char* const shape : {"(3,)", "(3, 1)", "(1, 3)"}) {
    for (const bool fortran : {false, true}) {
      EXPECT_EQ(points(npy(header_of("<c16", fortran, shape), data_of("<f8", true, expected))), expected) << shape;
      EXPECT_EQ(points(npy(header_of(">c8", fortran, shape), data_of(">f4", true, expected))), expected) << shape;
    }
  }
  EXPECT_EQ(read_error(npy(header_of("<i4", false, "(3, 2)"), "12345")),
            "in: the NPY header promises 6 numbers of 4 bytes, there are 5 bytes");
}

TEST(Npy, EveryTruncationIsAnError) {
  const std::string whole = npy(header_of("<f8", false, "(3, 2)"), data_of("<f8", true, binary_points));
  for (std::size_t size = 6; size < whole.size(); ++size) {
    EXPECT_NE(read_error(whole.substr(0, size)), "no error") << size;
  }
  EXPECT_NE(read_error(whole + '\0'), "no error");
}

TEST(Npy, NamesThePointThatIsNotFinite) {
  std::vector<Point> points(200000, Point{1, 2});
  points[123456].y = std::numeric_limits<double>::infinity();
  points[150000].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(read_error(npy(header_of("<f8", false, "(200000, 2)"), data_of("<f8", true, points))),
            "in: point 123456 is not a finite number");
}

TEST(Raw, ReadsPairs) {
  const CurveFile file = read(data_of("=f8", true, binary_points));
  EXPECT_EQ(file.format, Format::raw);
  ASSERT_EQ(file.zones.size(), 1U);
  EXPECT_EQ(file.zones[0].points, binary_points);
}

TEST(Raw, RefusesOtherSizesAndOtherNumbers) {
  const std::string data = data_of("=f8", true, binary_points);
  EXPECT_EQ(read_error(data.substr(1)),
            "in: neither text nor NPY, and 47 bytes are not a whole number of raw float64 pairs");
  std::vector<Point> points = binary_points;
  points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(read_error(data_of("=f8", true, points)), "in: point 1 is not a finite number");
}

}  // namespace
}  // namespace lober
