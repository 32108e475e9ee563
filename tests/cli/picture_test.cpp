// The options of pictures, and pictures of extreme windows.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "cli/picture/conversion.hpp"
#include "cli/picture/figure_svg.hpp"
#include "cli/picture/ticks.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

std::string texts(const Ticks& ticks) {
  std::string all;
  for (const Tick& tick : ticks.list) all += tick.text + " ";
  return all + "| " + ticks.offset + " | " + std::to_string(ticks.power);
}

TEST(Ticks, AreRoundAndTellNumbersApart) {
  EXPECT_EQ(texts(ticks_between(-1, 1, 4)), "\u22121.0 \u22120.5 0.0 0.5 1.0 |  | 0");
  EXPECT_EQ(texts(ticks_between(1, 4, 8, true)), "1 2 3 4 |  | 0");
  const Ticks far = ticks_between(1e6, 1e6 + 1e-6, 4);
  EXPECT_EQ(far.offset, "\u2212 1000000");
  EXPECT_EQ(far.power, -6);
  ASSERT_GE(far.list.size(), 3U);
  EXPECT_NE(far.list[0].text, far.list[1].text);
}

// The largest number in a picture, which browsers keep in 32 bits.
double largest_number(const std::string& svg) {
  double largest = 0;
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 1)) {
    const std::size_t end = svg.find('"', at + 4);
    for (std::size_t k = at + 4; k < end;) {
      char* after = nullptr;
      const double value = std::strtod(svg.c_str() + k, &after);
      const auto next = static_cast<std::size_t>(after - svg.c_str());
      largest = std::max(largest, next > k ? std::fabs(value) : 0);
      k = std::max(next, k + 1);
    }
  }
  return largest;
}

TEST(FigureSvg, HasSmallCoordinatesInAnyWindow) {
  for (const double scale : {1e-300, 1e-12, 1.0, 1e12, 1e300}) {
    Figure figure;
    figure.layers.push_back(line_layer("line", "", palette::ink));
    // Through the middle of the window, from far beyond it.
    figure.layers.back().lines.push_back({.own = {{-1e6 * scale, -1e6 * scale}, {1e6 * scale, 1e6 * scale}}});
    figure.window = {-scale, -scale, scale, scale};
    const std::string svg = figure_svg(figure, {});
    EXPECT_LT(largest_number(svg), 40'000) << scale;
    EXPECT_NE(svg.find("stroke-width=\"24\" d=\"M"), std::string::npos) << scale;
    EXPECT_EQ(svg.find("nan"), std::string::npos) << scale;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << scale;
  }
}

class PictureProgram : public ProgramTest {};

TEST_F(PictureProgram, WritesEachFormat) {
  const std::string curve = std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat";
  const std::vector<std::string> overlay{"overlay", curve + "#C1", curve + "#C2"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), overlay.begin(), overlay.end());
    return run(more);
  };
  ASSERT_EQ(with({"--picture", "p.svg", "--size", "120", "--no-legend", "--inset", "2,-1,4,1"}).status, 0);
  const std::string svg = read("p.svg");
  EXPECT_NE(svg.find("width=\"120mm\""), std::string::npos);
  EXPECT_NE(svg.find("url(#inset)"), std::string::npos);
  EXPECT_EQ(svg.find("C1, area"), std::string::npos);
  ASSERT_EQ(with({"--data", "p.csv"}).status, 0);
  EXPECT_TRUE(read("p.csv").starts_with("layer,item,name,x,y,error\n"));
  ASSERT_EQ(with({"--data", "p.json"}).status, 0);
  EXPECT_NE(read("p.json").find("\"layers\""), std::string::npos);
  const Outcome pdf = with({"--picture", "p.pdf"}), png = with({"--picture", "p.png"});
  if (!reason_no_conversion().empty()) {
    EXPECT_EQ(pdf.status, 1);
    EXPECT_NE(pdf.err.find("install the package"), std::string::npos) << pdf.err;
    GTEST_SKIP() << reason_no_conversion();
  }
  ASSERT_EQ(pdf.status, 0) << pdf.err;
  ASSERT_EQ(png.status, 0) << png.err;
  EXPECT_TRUE(read("p.pdf").starts_with("%PDF"));
  EXPECT_TRUE(read("p.png").starts_with("\x89PNG"));
  const std::string first = read("p.pdf");
  ASSERT_EQ(with({"--picture", "p.pdf"}).status, 0);
  EXPECT_EQ(read("p.pdf"), first);
}

}  // namespace
}  // namespace lober::cli
