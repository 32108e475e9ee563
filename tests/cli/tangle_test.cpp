// `lober tangle` on manifolds with known answers, its files, and what is unusual.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/tangle_program.hpp"
#include "tests/paths.hpp"
#include "tests/views.hpp"

namespace lober::cli {
using namespace lober::detail;
namespace {

using Numbers = std::vector<double>;

// Lobes that grow by two hundredths a period: alike enough to infer the period, but no area-preserving map makes them.
// Who gives the period says nothing of areas.
TEST_F(TangleProgram, SaysWhenImagesHaveOtherAreas) {
  std::vector<Point> wave;
  for (int k = 4000; k >= 0; --k) {
    const double x = 0.5 + k * 0.005;
    wave.push_back({x, (1 + 0.01 * x / std::numbers::pi) * std::sin(x)});
  }
  write_curve("u", std::vector<Point>{{0, 0}, {21, 0}});
  write_curve("s", wave);
  const Outcome outcome = run({"tangle", "u", "s", "--json", "t.json"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("DISAGREEMENT: area of lobe ")) << outcome.out;
  EXPECT_EQ(Json::parse(read("t.json"))["agreement"], false);
  EXPECT_EQ(tangle({"u", "s", "--period", "2", "--closure", "20.5,3,-1,3"})["agreement"], true);
}

// Both manifolds begin at one saddle, and a path there may have any corners: its loop is one more part where the other
// side of it lies, and all of the area where it lies round the rest. Signed areas take parts away or count them twice.
TEST_F(TangleProgram, APathMayBeALoop) {
  const double region = tangle({demo, "--closure", "4,2,4,4"})["boundary"]["area"].get<double>() - 2;  // of a triangle
  EXPECT_NEAR(region, 6.4101, 1e-4);
  for (const std::string smooth : {"", "--smooth"}) {
    const auto found = [&](const std::string& corners) {
      std::vector<std::string> arguments{"tangle", demo, "--closure", corners, "--json", "-"};
      if (!smooth.empty()) arguments.push_back(smooth);
      return Json::parse(run(arguments).out);
    };
    const Json beside = found("4,4,4,2")["boundary"];
    EXPECT_NEAR(beside["area"].get<double>(), region + 2, smooth.empty() ? 1e-12 : 2e-4);
    EXPECT_EQ(beside["crosses_itself"], true);
    const Json round = found("-4,4,-4,-4,4,-4");
    EXPECT_NEAR(round["boundary"]["area"].get<double>(), 48, 1e-12);
    EXPECT_NEAR(round["lobes"][3]["outside"].get<double>(), 0, 1e-12);
  }
}

TEST_F(TangleProgram, FindsPipsLobesAndBoundary) {
  const Json result = tangle({"u", "s"});
  EXPECT_EQ(result["crossings"]["count"], 4);
  EXPECT_EQ(column(result["pips"], "x"), (Numbers{2, 4, 6, 7.5}));
  EXPECT_EQ(column(result["pips"], "y"), (Numbers{0, 0, 0, 0}));
  EXPECT_EQ(column(result["lobes"], "area"), (Numbers{-1, 1, -0.75}));
  EXPECT_EQ(column(result["lobes"], "inside"), (Numbers{0, 1, 0.75}));
  EXPECT_EQ(column(result["lobes"], "outside"), (Numbers{1, 0, 0}));
  EXPECT_DOUBLE_EQ(result["lobes"][0]["perimeter"], 2 + 2 * std::sqrt(2.0));
  EXPECT_EQ(result["bip"], (Json{{"index", 2}, {"x", 6.0}, {"y", 0.0}}));
  EXPECT_EQ(result["boundary"]["area"], 12.0);
  EXPECT_EQ(result["boundary"]["points"], 4);
  EXPECT_EQ(result["pips"][3]["s"], (Json{{"segment", 0}, {"t", 0.75}}));
  EXPECT_EQ(result["pips"][3]["rho"], -result["pips"][2]["rho"].get<int>());
  EXPECT_TRUE(result["images"]["period"].is_null());
  EXPECT_TRUE(result["turnstile"]["reason"].is_string());
  EXPECT_TRUE(result["lobes"][0]["label"].is_null());
}

TEST_F(TangleProgram, TakesABipByNumberAndByPlace) {
  for (const char* bip : {"1", "4.1,-3"}) {
    const Json result = tangle({"u", "s", "--bip", bip});
    EXPECT_EQ(result["bip"]["index"], 1);
    EXPECT_EQ(result["bip"]["x"], 4.0);
  }
  expect_failure({"tangle", "u", "s", "--bip", "4"}, 2, "no pip 4");
  expect_failure({"tangle", "u", "s", "--bip", "100,100"}, 2, "no pip lies near the bip asked for, (100, 100)");
  for (const char* bip : {"-1", "x", "1,", ",2", "1,2,3", "1,nan", "1.5"}) {
    expect_failure({"tangle", "u", "s", "--bip", bip}, 2, "--bip");
  }
}

TEST_F(TangleProgram, RefusesADirectionOfNoLength) {
  expect_failure({"tangle", "henon", "--u-direction", "0,0"}, 2, "a direction cannot be the vector 0, 0");
  expect_failure({"tangle", "henon", "--s-direction", "0,0"}, 2, "a direction cannot be the vector 0, 0");
}

// Manifolds of an angle that are stored modulo its period: which copy of S belongs to U follows from where they lead.
TEST_F(TangleProgram, FindsTheCopyOfAManifoldThatIsAPeriodAway) {
  constexpr double period = 2 * std::numbers::pi;
  ASSERT_EQ(run({"grow", "standard", "--param", "K=1.2", "--unstable", "--from", "0,0", "--branch", "+", "--length",
                 "14", "--tolerance", "1e-5", "-o", "grown_u.txt"})
                .status,
            0);
  ASSERT_EQ(run({"grow", "standard", "--param", "K=1.2", "--stable", "--from", "0,0", "--branch", "-", "--length", "14",
                 "--tolerance", "1e-5", "-o", "grown_s.txt"})
                .status,
            0);
  const auto points_of = [&](const std::string& name) {
    std::vector<Point> points;
    std::istringstream lines(read(name));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream numbers(line);
      Point point;
      if (numbers >> point.x >> point.y) points.push_back(point);
    }
    return points;
  };
  const auto stored = [&](std::vector<Point> points) {
    for (Point& point : points) point.x -= period * std::floor(point.x / period);
    return points;
  };
  const std::vector<Point> u = points_of("grown_u.txt"), s = points_of("grown_s.txt");
  std::vector<Point> next = s;
  for (Point& point : next) point.x += period;
  write_curve("u", u);
  write_curve("s", next);
  const Json expected = tangle({"u", "s"});
  EXPECT_NEAR(expected["boundary"]["area"], 8.572, 1e-3);
  for (const double copies : {-3.0, 0.0, 1.0, 7.0}) {
    std::vector<Point> moved = stored(s);
    for (Point& point : moved) point.x += copies * period;
    write_curve("stored_u", stored(u));
    write_curve("stored_s", moved);
    const Json found = tangle({"stored_u", "stored_s", "--periodic", "x=2pi"});
    EXPECT_NEAR(found["boundary"]["area"], expected["boundary"]["area"], 1e-9) << copies;
    EXPECT_EQ(found["pips"].size(), expected["pips"].size()) << copies;
    const Outcome outcome = run({"tangle", "stored_u", "stored_s", "--periodic", "x=2pi"});
    EXPECT_NE(outcome.out.find("copies of S by other periods exist"), std::string::npos) << outcome.out;
    if (copies == -3.0) {
      EXPECT_NE(outcome.out.find("S is taken +4 periods in x"), std::string::npos) << outcome.out;
    }
  }
}

TEST_F(TangleProgram, TakesAPeriod) {
  const Json result = tangle({"u", "s", "--period", "2"});
  EXPECT_EQ(result["images"]["period"], 2);
  EXPECT_EQ(result["images"]["given"], true);
  EXPECT_EQ(result["turnstile"]["lobes"], Json::array({0, 1}));
  EXPECT_EQ(result["turnstile"]["lobe_area12"], 1.0);
  EXPECT_EQ(result["turnstile"]["lobe_area21"], 1.0);
  const double mean = 2.75 / 3;
  EXPECT_DOUBLE_EQ(result["error"]["consistency"]["area_change"], 0.25 / mean);
  EXPECT_DOUBLE_EQ(result["error"]["consistency"]["turnstile_sum"], 0.25 / mean);
  EXPECT_EQ(result["lobes"][0]["label"], "L21(1)");
  EXPECT_EQ(result["lobes"][1]["label"], "L12(1)");
  EXPECT_EQ(result["lobes"][2]["label"], "L21(0)");
  expect_failure({"tangle", "u", "s", "--period", "0"}, 2, "--period");
}

// The other way of looking at it: pips in the opposite order, areas of the opposite sign.
TEST_F(TangleProgram, SwapsUAndS) {
  const Json plain = tangle({demo + "#0", demo + "#1"}), swapped = tangle({demo + "#1", demo + "#0"});
  Numbers areas = column(swapped["lobes"], "area"), inside = column(swapped["lobes"], "inside");
  std::reverse(areas.begin(), areas.end());
  std::reverse(inside.begin(), inside.end());
  ASSERT_EQ(areas.size(), 10U);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    EXPECT_NEAR(areas[k], plain["lobes"][k]["area"].get<double>(), 1e-15);
    EXPECT_NEAR(inside[k], plain["lobes"][k]["inside"].get<double>(), 1e-15);
  }
  EXPECT_EQ(swapped["boundary"]["area"], plain["boundary"]["area"]);
}

TEST_F(TangleProgram, TakesOneFileOfTwoZones) {
  const Json apart = tangle({demo + "#0", demo + "#1"}), together = tangle({demo});
  for (const char* member : {"inputs", "pips", "lobes", "boundary"}) EXPECT_EQ(apart[member], together[member]);
  EXPECT_EQ(together["inputs"][1]["zone"], 1);
  write("three", "ZONE\n0 0\n1 1\nZONE\n0 0\n1 1\nZONE\n0 0\n1 1\n");
  expect_failure({"tangle", "three"}, 1, "three: has 3 zones; alone it has to have two");
  expect_failure({"tangle", "u"}, 1, "u");
}

// The lobes of the true manifolds have area 0.36598843872559149, the region that pip 4 bounds 6.0441780571922164.
TEST_F(TangleProgram, GetsTheHenonMapRight) {
  const Json result = tangle({demo, "--bip", "4", "--overlaps", "--lobes", "lobes"});
  const Json& lobes = result["lobes"];
  ASSERT_EQ(lobes.size(), 10U);
  for (std::size_t k = 0; k < lobes.size(); ++k) {
    const double sign = k % 2 == 0 ? 1 : -1;
    EXPECT_NEAR(sign * lobes[k]["area"].get<double>(), 0.36598843872559149,
                2 * lobes[k]["discretisation"].get<double>());
  }
  EXPECT_NEAR(result["boundary"]["area"], 6.0441780571922164, 2e-4);
  EXPECT_EQ(result["images"]["period"], 2);
  // The overlay, which shares nothing with the sums along the manifolds but the crossings, agrees.
  ASSERT_EQ(result["overlaps"].size(), 1U);
  const Json both = overlay({"lobes#0", "lobes#9"});
  EXPECT_EQ(result["overlaps"][0]["i"], 0);
  EXPECT_EQ(result["overlaps"][0]["j"], 9);
  EXPECT_NEAR(result["overlaps"][0]["area"], both["areas"]["intersection"].get<double>(), 1e-14);
}

// The example is rounded to eight decimals, which is what is left of the error.
TEST_F(TangleProgram, GetsItBetterBySmoothCurves) {
  const Json result = tangle({demo, "--smooth"}), plain = tangle({demo});
  for (std::size_t k = 0; k < 10; ++k) {
    const Json& lobe = result["lobes"][k];
    EXPECT_NEAR(std::fabs(lobe["area"].get<double>()), 0.36598843872559149, 1e-7);
    EXPECT_EQ(lobe["polygon_area"], plain["lobes"][k]["area"]);
  }
  EXPECT_EQ(result["options"]["smooth"], true);
  EXPECT_LT(result["error"]["discretisation"]["lobe"], plain["error"]["discretisation"]["lobe"]);
}

TEST_F(TangleProgram, WritesFilesThatItCanRead) {
  const Outcome outcome =
      run({"tangle", demo, "--lobes", "lobes.dat", "--boundary", "boundary.dat", "--pips", "pips.dat"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json result = tangle({demo});
  const CurveFile lobes = read_curve_file(folder() / "lobes.dat");
  ASSERT_EQ(lobes.zones.size(), result["lobes"].size());
  for (std::size_t k = 0; k < lobes.zones.size(); ++k) {
    const double area = result["lobes"][k]["area"];
    EXPECT_NEAR(signed_area(CurveView{lobes.zones[k].points}), area, 1e-14) << lobes.zones[k].title;
    EXPECT_TRUE(lobes.zones[k].title.starts_with("lobe " + std::to_string(k) + " L")) << lobes.zones[k].title;
  }
  const CurveFile boundary = read_curve_file(folder() / "boundary.dat"), pips = read_curve_file(folder() / "pips.dat");
  EXPECT_NEAR(std::fabs(signed_area(CurveView{boundary.zones[0].points})), result["boundary"]["area"].get<double>(),
              1e-14);
  EXPECT_EQ(boundary.zones[0].points.size(), result["boundary"]["points"]);
  // The boundary is a polygon where formats have them; pips are points in order.
  ASSERT_EQ(run({"tangle", demo, "--boundary", "boundary.wkt", "--pips", "pips.wkt"}).status, 0);
  EXPECT_TRUE(read("boundary.wkt").starts_with("POLYGON ((")) << read("boundary.wkt").substr(0, 1000);
  EXPECT_TRUE(read("pips.wkt").starts_with("LINESTRING (")) << read("pips.wkt");
  ASSERT_EQ(pips.zones[0].points.size(), result["pips"].size());
  EXPECT_EQ(pips.zones[0].points[3], (Point{result["pips"][3]["x"], result["pips"][3]["y"]}));
}

TEST_F(TangleProgram, PrintsAShortTable) {
  const Outcome outcome = run({"tangle", demo, "--overlaps"});
  EXPECT_EQ(outcome.err, "");
  for (const char* words : {"15 crossings", "11 pips, 10 lobes", "bip 5", "2 pips further (inferred)", "L12(1)",
                            "L21(0)", "1 pair of lobes overlap"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
  }
  EXPECT_LT(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 30);
}

TEST_F(TangleProgram, ListsThePiecesOfALobeThatTouchesItself) {
  write_curve("touching", std::vector<Point>{{3, 3}, {3, -1}, {2, 0}, {1, -1}, {0, 2}});
  const Json result = tangle({"u", "touching"});
  ASSERT_EQ(result["lobes"].size(), 1U);
  EXPECT_EQ(result["lobes"][0]["simple"], false);
  ASSERT_EQ(result["lobes"][0]["pieces"].size(), 2U);
  EXPECT_DOUBLE_EQ(result["lobes"][0]["pieces"][0], 0.5);
  EXPECT_DOUBLE_EQ(result["lobes"][0]["pieces"][1], 2.0 / 3);
  EXPECT_NE(run({"tangle", "u", "touching"}).out.find("not simple"), std::string::npos);
}

TEST_F(TangleProgram, AreasBeyondTheRangeOfDoubleAreAnError) {
  write_curve("large", std::vector<Point>{{0, 0}, {1e300, 0}});
  write_curve("larger", std::vector<Point>{{1.5e300, 1e300}, {1e299, -1e300}, {-1e300, 1e300}});
  const Outcome outcome = run({"tangle", "large", "larger", "--svg", "picture", "--json", "-"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("larger than the largest double"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(TangleProgram, SaysThatThereIsNoCrossing) {
  write_curve("apart", std::vector<Point>{{0, 5}, {9, 5}});
  const Json result = warned({"u", "apart", "--overlaps"}, "do not cross");
  for (const char* list : {"pips", "lobes", "overlaps"}) EXPECT_EQ(result[list], Json::array());
  for (const char* member : {"bip", "boundary"}) EXPECT_TRUE(result[member].is_null());
  const Outcome outcome =
      run({"tangle", "u", "apart", "--lobes", "l", "--boundary", "b", "--pips", "p", "--svg", "v", "--graph", "g"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("0 pips, 0 lobes"), std::string::npos) << outcome.out;
  for (const char* file : {"l", "b", "p"}) {
    const std::string text = read(file);
    EXPECT_TRUE(text.starts_with("# lober: ")) << text;
    EXPECT_NE(text.find("\n# input 2: apart sha256 "), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\nVARIABLES=\"x\"\"y\"\n")) << text;
  }
  EXPECT_EQ(Json::parse(read("g"))["nodes"], Json::array());
  expect_failure({"tangle", "u", "apart", "--bip", "0"}, 2, "do not cross");
}

TEST_F(TangleProgram, SaysThatThereIsOnePipOnly) {
  write_curve("once", std::vector<Point>{{9, 3}, {9, -3}});
  const Json result = warned({"u", "once"}, "one pip only");
  EXPECT_EQ(result["pips"].size(), 1U);
  EXPECT_EQ(result["boundary"]["area"], 13.5);
}

TEST_F(TangleProgram, NoticesManifoldsGivenInward) {
  const CurveFile file = read_curve_file(demo);
  std::vector<Point> inward(file.zones[0].points.rbegin(), file.zones[0].points.rend());
  write_curve("inward", inward);
  EXPECT_LT(warned({"inward", demo + "#1"}, "given inward")["pips"].size(), 5U);
  const Json turned = tangle({"inward", demo + "#1", "--reverse", "u"}), plain = tangle({demo});
  EXPECT_EQ(turned["lobes"], plain["lobes"]);
  EXPECT_EQ(turned["inputs"][0]["reversed"], true);
  EXPECT_EQ(turned["inputs"][1]["reversed"], false);
}

TEST_F(TangleProgram, TakesRepeatedFirstPoints) {
  const CurveFile file = read_curve_file(demo);
  std::vector<Point> repeated = file.zones[0].points;
  repeated.insert(repeated.begin(), 3, repeated[0]);
  write_curve("repeated", repeated);
  const Json lobes = tangle({"repeated", demo + "#1"})["lobes"], plain = tangle({demo})["lobes"];
  for (const char* name : {"area", "inside", "outside"}) EXPECT_EQ(column(lobes, name), column(plain, name));
}

TEST_F(TangleProgram, NamesTheManifoldThatCrossesItself) {
  write_curve("loop", std::vector<Point>{{0, 5}, {4, 5}, {4, 7}, {2, 3}, {2, -1}});
  expect_failure({"tangle", "u", "loop"}, 1, "loop: S crosses or touches itself: segments 0 and 2 meet at (3, 5)");
  expect_failure({"tangle", "loop", "u"}, 1, "U crosses or touches itself");
  expect_failure({"tangle", "loop", "u"}, 1, "--no-check-simple");
  EXPECT_EQ(run({"tangle", "loop", "u", "--no-check-simple"}).status, 0);
}

TEST_F(TangleProgram, RefusesWhatItCannotDo) {
  expect_failure({"tangle"}, 2, "U");
  expect_failure({"tangle", "u", "s", "more"}, 2, "more");
  expect_failure({"tangle", "u", "nowhere"}, 1, "nowhere");
  expect_failure({"tangle", demo + "#2", "s"}, 1, "no zone 2");
  expect_failure({"tangle", "u", "s", "--json", "u"}, 2, "overwrite the input");
  expect_failure({"tangle", "u", "s", "--json", "x", "--graph", "x"}, 2, "both write");
  expect_failure({"tangle", "u", "s", "--svg", "no/where"}, 1, "cannot be written");
  expect_failure({"tangle", "u", "s", "--reverse", "v"}, 2, "--reverse");
}

// The direction of grown manifolds is known.
TEST_F(TangleProgram, DoesNotQuestionTheDirectionOfGrownManifolds) {
  const Outcome outcome = run({"tangle", "--system", "standard", "--param", "K=50", "--json", "t.json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ((outcome.out + outcome.err + read("t.json")).find("given inward"), std::string::npos) << outcome.err;
}

// K = 10.7 and 10.8 once had different ones: the nearest pip to a place that was nowhere near the pip on the axis.
TEST_F(TangleProgram, KeepsToThePipOnTheAxisOfTheStandardMap) {
  double before = 0;
  for (const char* k : {"2", "6", "10.7", "10.8", "20"}) {
    const Json result = tangle({"--system", "standard", "--param", std::string("K=") + k});
    const std::size_t bip = result["bip"]["index"];
    const Json pip = result["pips"].at(bip);
    EXPECT_NEAR(pip["x"].get<double>(), std::numbers::pi, 1e-4) << k;
    EXPECT_GT(pip["y"].get<double>(), before) << k;
    EXPECT_LT(pip["y"].get<double>(), std::numbers::pi) << k;
    before = pip["y"];
  }
}

// A saddle that is not the system's own is joined to itself, whatever period its own tangle is over.
TEST_F(TangleProgram, JoinsOtherSaddlesToThemselves) {
  const Outcome outcome = run({"tangle", "--system", "standard", "--param", "K=5", "--from=3.14159,0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("DISAGREEMENT"), std::string::npos) << outcome.out;
}

// S of a lobe of the turnstile runs a million away; as long as it was followed coarsely there, the area was wrong by
// 160 and its bar infinite.
TEST_F(TangleProgram, FollowsLobesThatReachFar) {
  const Outcome outcome = run({"tangle", "henon", "--param", "k=1000"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("-42164.68656"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find(" inf"), std::string::npos) << outcome.out;
  const Outcome stretched = run({"transport", "double-gyre", "--param", "A=0.3"});
  EXPECT_EQ(stretched.status, 1);
  EXPECT_NE(stretched.err.find("one iterate stretches by"), std::string::npos) << stretched.err;
}

TEST_F(TangleProgram, TakesTheNameOfASystemByItself) {
  const Outcome with_option = run({"tangle", "--system", "duffing"});
  ASSERT_EQ(with_option.status, 0) << with_option.err;
  const Outcome alone = run({"tangle", "duffing"});
  EXPECT_EQ(alone.out, with_option.out) << alone.err;
  EXPECT_NE(run({"tangle", "duffing", "--help"}).out.find("--before"), std::string::npos);
  const Outcome behind = run({"tangle", "--svg", "a.svg", "--param", "eps=0.1", "duffing"});
  EXPECT_EQ(behind.out, with_option.out) << behind.err;
  expect_failure({"tangle", "duffin"}, 2, "duffin is neither a file nor a system; the systems are abc, capsize");
  // A file of that name is a file.
  write("duffing", "1 2\n3 4\n");
  const Outcome file = run({"tangle", "duffing"});
  EXPECT_NE(file.err.find("zone"), std::string::npos) << file.err;
  EXPECT_NE(file.err.find("the file duffing is read; --system duffing is the system"), std::string::npos) << file.err;
}

// f is x -> a reflection through the saddle: f^2 keeps the branches.
TEST_F(TangleProgram, SaysThatSaddlesWithReflectionCountSecondIterates) {
  const Outcome grown = run({"grow", "standard", "--param", "K=5", "--from", "3.14159265,0", "--unstable",
                             "--tolerance", "1e-3", "--iterates", "3", "--json", "g.json", "-o", "g.npy"});
  ASSERT_EQ(grown.status, 0) << grown.err;
  EXPECT_NE(grown.out.find("images are those of f^2"), std::string::npos) << grown.out;
  const Json json = Json::parse(read("g.json"));
  EXPECT_EQ(json["local_manifold"]["reflection"], true);
  EXPECT_EQ(json["local_manifold"]["steps_of_image"], 2);
  const Json plain = tangle({"--system", "standard", "--param", "K=2"});
  EXPECT_EQ(plain["reflection"], false);
  EXPECT_EQ(plain["steps_of_image"], 1);
}

}  // namespace
}  // namespace lober::cli
