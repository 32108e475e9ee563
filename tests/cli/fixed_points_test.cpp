// `lober fixed-points`: fixed and periodic points with multipliers, residues and types.
#include <set>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class FixedPointsProgram : public ProgramTest {
 protected:
  [[nodiscard]] Json points(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "fixed-points");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

// The saddle of the three-body problem and its multiplier, from 30 digits.
TEST_F(FixedPointsProgram, HaveMultipliersAndTypes) {
  const Json found = points({"pcr3bp"})["points"];
  ASSERT_EQ(found.size(), 4U);
  EXPECT_NEAR(found[0]["x"].get<double>(), -2.02957956736457496, 1e-12);
  EXPECT_EQ(found[0]["type"], "saddle");
  EXPECT_NEAR(found[0]["multipliers"][0][0].get<double>(), 31.552237923806206, 1e-9);
  EXPECT_NEAR(found[0]["multipliers"][0][0].get<double>() * found[0]["multipliers"][1][0].get<double>(), 1, 1e-10);
  EXPECT_EQ(found[0]["rotation"], nullptr);
  EXPECT_EQ(found[3]["type"], "centre");
  EXPECT_EQ(found[3]["directions"], nullptr);
  EXPECT_GT(found[3]["rotation"].get<double>(), 0);
}

// A resonance 2/5 of the standard map: five saddles and five centres on the cylinder.
TEST_F(FixedPointsProgram, MayTurnRoundTheCylinder) {
  const Json result = points({"standard", "--period", "5", "--turns", "2", "--box", "-0.1,0,6.1,6"});
  std::size_t saddles = 0;
  for (const Json& point : result["points"]) {
    EXPECT_EQ(point["period"], 5);
    saddles += point["type"] == "saddle" ? 1U : 0U;
  }
  EXPECT_EQ(result["points"].size(), 10U);
  EXPECT_EQ(saddles, 5U);
  EXPECT_EQ(result["search"]["settled"], true);
  EXPECT_EQ(result["search"]["index_of_box"], 0);
  const Outcome text = run({"fixed-points", "standard", "--csv", "points.csv"});
  EXPECT_NE(text.out.find("the index of the box is 0, the sum of the points' 0"), std::string::npos) << text.out;
  EXPECT_TRUE(read("points.csv").starts_with("x,y,period,type,residue,index,")) << read("points.csv");
  EXPECT_NE(read("points.csv").find(",1,\"saddle\",-0.3"), std::string::npos) << read("points.csv");
  EXPECT_NE(read("points.csv").find(",1,\"centre\",0.3"), std::string::npos) << read("points.csv");
}

TEST_F(FixedPointsProgram, HalfATurnIsNoPeriod) {
  const Json two = points({"standard", "--param", "K=1.2", "--period", "2", "--turns", "1", "--box", "-1,3,5.5,3.3"});
  EXPECT_EQ(two["search"]["settled"], true);
  ASSERT_EQ(two["points"].size(), 2U);
  for (const Json& point : two["points"]) {
    EXPECT_EQ(point["period"], 2);
    EXPECT_NEAR(point["residue"].get<double>(), 0.36, 1e-13);  // K^2 / 4
  }
}

// Without a kick each point of the axis is fixed.
TEST_F(FixedPointsProgram, SaysWherePointsAreNotIsolated) {
  const Outcome text = run({"fixed-points", "standard", "--param", "K=0"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("NOT ISOLATED: fixed points fill a curve or an area"), std::string::npos) << text.out;
  const Json result = points({"standard", "--param", "K=0"});
  EXPECT_EQ(result["search"]["isolated"], false);
  EXPECT_EQ(result["search"]["settled"], false);
  EXPECT_GE(result["points"].size(), 6U);
  for (const Json& point : result["points"]) EXPECT_NEAR(point["y"].get<double>(), 0, 1e-9);
  EXPECT_EQ(points({"standard", "--param", "K=0.1"})["search"]["isolated"], true);
}

TEST_F(FixedPointsProgram, HaveAColourForEachPeriodInPictures) {
  ASSERT_EQ(run({"fixed-points", "henon", "--period", "5", "--picture", "p.svg"}).status, 0);
  EXPECT_NE(read("p.svg").find("#7b2d8b"), std::string::npos);
  ASSERT_EQ(run({"fixed-points", "henon", "--picture", "p.svg"}).status, 0);
  EXPECT_EQ(read("p.svg").find("#7b2d8b"), std::string::npos);
}

TEST_F(FixedPointsProgram, MayBeNone) {
  const Outcome text = run({"fixed-points", "henon", "--box", "5,5,6,6"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("0 points found"), std::string::npos) << text.out;
}

TEST_F(FixedPointsProgram, HasTheSameBytesForAnyNumberOfThreads) {
  std::set<std::string> seen;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = run({"fixed-points", "capsize", "--threads", threads, "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    seen.insert(without_timing(outcome.out));
  }
  EXPECT_EQ(seen.size(), 1U);
}

TEST_F(FixedPointsProgram, RefusesWhatMakesNoSense) {
  const auto refused = [&](std::vector<std::string> arguments, const std::string& words) {
    arguments.insert(arguments.begin(), "fixed-points");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused({}, "--system is missing");
  refused({"nosuch"}, "nosuch");
  refused({"henon", "--period", "0"}, "--period");
  refused({"henon", "--turns", "1"}, "leave --turns out");
  refused({"henon", "--box", "1,1,0,2"}, "x0 < x1");
  refused({"henon", "--grid", "1"}, "--grid");
  refused({"henon", "--grid", "100", "--max-grid", "50"}, "--max-grid has to be at least");
  refused({"ovp", "--param", "eps=9"}, "eps must be in [-8, 8], not 9");
  refused({"pcr3bp", "--param", "mu=0.6"}, "mu must be in [0, 0.5], not 0.6");
  refused({"henon", "--csv", "points.json"}, "--csv");
}

}  // namespace
}  // namespace lober::cli
