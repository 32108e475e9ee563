// `lober overlay --smooth`.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class OverlaySmooth : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("c1", flower(1000, 5, 0.0, {0, 0}));
    write_curve("c2", flower(1000, 5, 0.0, {0.7, 0}));
  }
};

TEST_F(OverlaySmooth, StandsBesideThePolygons) {
  const Json result = overlay({"c1", "c2", "--smooth"}), plain = overlay({"c1", "c2"});
  EXPECT_FALSE(plain.contains("smooth"));
  EXPECT_EQ(result["areas"], plain["areas"]);
  const Json& smooth = result["smooth"];
  EXPECT_EQ(smooth["fallback_segments"], 0);
  EXPECT_EQ(smooth["fallback_crossings"], 0);
  EXPECT_NEAR(smooth["areas"]["c1"].get<double>(), std::numbers::pi, 1e-12);
  EXPECT_LT(smooth["error"]["c1"].get<double>(), 1e-8);
  EXPECT_GT(std::abs(result["areas"]["c1"].get<double>() - std::numbers::pi), 1e-6);
  EXPECT_TRUE(smooth["areas"].contains("symmetric_difference"));
}

// On coarse curves the estimate from the polygons alone is too small; smooth curves show it.
TEST_F(OverlaySmooth, WidensTheBarOfThePolygons) {
  write_curve("c1", flower(9, 1, 0.1, {0, 0}));
  write_curve("c2", flower(8, 1, 0.0, {0.2, 0.2}));
  const Json result = overlay({"c1", "c2", "--smooth"}), plain = overlay({"c1", "c2"});
  const double difference = result["smooth"]["areas"]["c2"].get<double>() - plain["areas"]["c2"].get<double>();
  EXPECT_GT(difference, plain["error"]["discretisation"]["c2"].get<double>());
  EXPECT_GE(result["error"]["discretisation"]["c2"].get<double>(), difference);
  EXPECT_EQ(result["agreement"], true);
}

// A lens that polygons have a tenth of: both routes are right, and say so.
TEST_F(OverlaySmooth, AgreesWithPolygonsOnAThinLens) {
  const auto circle = [](std::size_t points, double x) { return flower(points, 1, 0.0, {x, 0}); };
  write_curve("c1", circle(500, 0));
  write_curve("c2", circle(200, 1.99999));
  const Outcome outcome = run({"overlay", "c1", "c2", "--smooth"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json plain = overlay({"c1", "c2"});
  const double lost = 4.21636705132e-8 - plain["areas"]["intersection"].get<double>();
  EXPECT_NEAR(plain["error"]["discretisation"]["intersection"].get<double>(), lost, 0.02 * lost);
}

TEST_F(OverlaySmooth, HasAColumnInTheTable) {
  const Outcome outcome = run({"overlay", "c1", "c2", "--smooth", "--areas-only"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("smooth"), std::string::npos);
  EXPECT_EQ(run({"overlay", "c1", "c2"}).out.find("smooth"), std::string::npos);
}

TEST_F(OverlaySmooth, TellsHowManySegmentsStayStraight) {
  write_curve("box", box(0, 0, 3, 2));
  EXPECT_EQ(overlay({"c1", "box", "--smooth"})["smooth"]["fallback_segments"], 4);
  EXPECT_NE(run({"overlay", "c1", "box", "--smooth"}).out.find("not smooth: 4 segments"), std::string::npos);
}

// Areas are in the range of double as long as coordinates are above 1e-154; what is below is not given as 0 without a
// word.
TEST_F(OverlaySmooth, OfVerySmallCurves) {
  const auto write_scaled = [&](double scale) {
    for (const auto& [name, x] : {std::pair{"c1", 0.0}, std::pair{"c2", 0.7}}) {
      std::vector<Point> points = flower(100, 5, 0.0, {x, 0});
      for (Point& p : points) p = {scale * p.x, scale * p.y};
      write_curve(name, points);
    }
  };
  write_scaled(1.01e-154);
  const Outcome in_range = run({"overlay", "c1", "c2", "--smooth"});
  EXPECT_EQ(in_range.status, 0) << in_range.err;
  EXPECT_EQ(in_range.err, "");
  for (const double scale : {1e-158, 1e-200}) {
    write_scaled(scale);
    for (const std::string command : {"overlay", "interior"}) {
      const Outcome below = run({command, "c1", "c2"});
      EXPECT_EQ(below.status, 0) << below.err;
      EXPECT_NE(below.err.find("areas below 2.2e-308"), std::string::npos) << command << ' ' << scale;
    }
    EXPECT_EQ(run({"overlay", "c1", "c2", "--smooth"}).status, 0);
    EXPECT_NE(run({"overlay", "c1", "c2", "--rule", "nonzero"}).err.find("areas below"), std::string::npos);
  }
}

TEST_F(OverlaySmooth, IsNotForRules) {
  EXPECT_EQ(run({"overlay", "c1", "c2", "--smooth", "--rule", "nonzero"}).status, 2);
}

}  // namespace
}  // namespace lober::cli
