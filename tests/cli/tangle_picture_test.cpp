#include <cmath>

#include "lober/curve/files.hpp"
#include "tests/cli/tangle_program.hpp"

namespace lober::cli {
namespace {

// The colour that the legend of a picture gives to an entry.
std::string colour_of(const std::string& svg, const std::string& entry) {
  const std::size_t text = svg.find(entry), line = svg.rfind("<g transform", text);
  const std::size_t fill = svg.find("fill=\"", line);
  return text == std::string::npos || fill > text ? "none" : svg.substr(fill + 6, 7);
}

// Whichever side of U the lobes lie on: mirrored manifolds exchange the sides.
TEST_F(TangleProgram, GivesLeavingAndEnteringLobesTheirColours) {
  const CurveFile file = read_curve_file(demo);
  for (const std::size_t zone : {0UL, 1UL}) {
    std::vector<Point> mirrored = file.zones[zone].points;
    for (Point& point : mirrored) point.y = -point.y;
    write_curve(zone == 0 ? "mirrored-u" : "mirrored-s", mirrored);
  }
  ASSERT_EQ(run({"tangle", demo, "--svg", "plain.svg"}).status, 0);
  ASSERT_EQ(run({"tangle", "mirrored-u", "mirrored-s", "--svg", "mirrored.svg"}).status, 0);
  ASSERT_EQ(run({"transport", "henon", "--iterates", "1", "--picture", "transport.svg"}).status, 0);
  const std::string leaving = colour_of(read("plain.svg"), "L12"), entering = colour_of(read("plain.svg"), "L21");
  EXPECT_NE(leaving, entering);
  for (const char* name : {"mirrored.svg", "transport.svg"}) {
    EXPECT_EQ(colour_of(read(name), "L12"), leaving) << name;
    EXPECT_EQ(colour_of(read(name), "L21"), entering) << name;
  }
}

TEST_F(TangleProgram, DrawsASmallPictureOfManyPoints) {
  std::vector<Point> wave, line{{0, 0}, {-1, -5}, {10, -5}};  // homoclinic
  constexpr int count = 200'000;
  for (int k = 0; k <= count; ++k) {
    const double x = 10.0 * k / count;
    wave.push_back({x, (1 + 0.3 * std::sin(977 * x)) * std::sin(631 * x)});
    line.push_back({10 - x, 1e-3 * std::cos(x)});
  }
  write_curve("wave", wave);
  write_curve("line", line);
  const Outcome outcome = run({"tangle", "wave", "line", "--period", "22", "--svg", "picture.svg"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string svg = read("picture.svg");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_LT(svg.size(), 1'000'000U);
  EXPECT_NE(svg.find("unstable manifold"), std::string::npos);
}

}  // namespace
}  // namespace lober::cli
