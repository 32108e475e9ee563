// `lober interior` on pairs with known answers, its table and its JSON.

#include <algorithm>
#include <set>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class InteriorProgram : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("c1", flower(3000, 31, 0.1, {0, 0}));
    write_curve("c2", flower(2000, 17, 0.2, {0.05, 0.02}));
  }
  std::pair<double, double> differences(const std::vector<Point>& c1, const std::vector<Point>& c2) {
    write_curve("left", c1);
    write_curve("right", c2);
    const Json areas = interior({"left", "right"})["areas"];
    return {areas["c1_minus_c2"], areas["c2_minus_c1"]};
  }
};

// Cases that Lober 1.8 gets wrong.
TEST_F(InteriorProgram, GetsSharedSidesRight) {
  using Pair = std::pair<double, double>;
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(0, 0, 2, 1)), Pair(0, 1));
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(0.5, 0, 1.5, 1)), Pair(0.5, 0.5));
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(1, 0.25, 2, 0.75)), Pair(1, 0.5));
  EXPECT_EQ(differences(box(0, 2, 6, 4), box(2, 0, 4, 6)), Pair(8, 8));
  const std::vector<Point> curve = flower(64, 3, 0.25, {0, 0});
  EXPECT_EQ(differences(curve, curve), Pair(0, 0));
}

TEST_F(InteriorProgram, VerifiesByTheOverlayWhenAsked) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--method", "ends"}, {"--method", "ends", "--passes", "2", "--points", "5"}}) {
    std::vector<std::string> arguments{"c1", "c2", "--verify"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json result = interior(arguments);
    EXPECT_EQ(result["agreement"], true);
    for (const auto& [name, difference] : result["error"]["consistency"].items()) {
      const double splitting = options.empty() ? 0 : result["error"]["splitting"][name].get<double>();
      EXPECT_LE(difference.get<double>(), splitting + 1e-15) << name;
    }
  }
  EXPECT_FALSE(interior({"c1", "c2"})["error"].contains("consistency"));
}

TEST_F(InteriorProgram, HasTheMembersOfTheContract) {
  const Json result = interior({"c1", "c2"});
  EXPECT_EQ(members(result), (std::set<std::string>{"program", "command", "inputs", "options", "crossings", "q1", "q2",
                                                    "q3", "areas", "delta", "error", "statistics", "timing",
                                                    "agreement", "disagreements", "orientation1", "orientation2"}));
  EXPECT_EQ(result["command"], "interior");
  EXPECT_EQ(result["options"]["method"], "split");
  EXPECT_EQ(members(result["error"]), (std::set<std::string>{"rounding"}));
  const Json reference = overlay({"c1", "c2"});
  EXPECT_EQ(result["inputs"], reference["inputs"]);
  EXPECT_EQ(members(result["areas"]), members(reference["areas"]));
  for (const auto& [name, area] : reference["areas"].items()) {
    EXPECT_NEAR(result["areas"][name], area, 1e-15 * area.get<double>()) << name;
  }
  EXPECT_EQ(result["q1"], result["areas"]["symmetric_difference"]);
  EXPECT_EQ(result["q2"], result["areas"]["union"]);
  EXPECT_EQ(result["q3"], result["areas"]["intersection"]);
  EXPECT_LT(result["delta"], 1e-28);
  for (const char* name : {"count", "contacts", "shared_arcs", "same_curve"}) {
    EXPECT_EQ(result["crossings"][name], reference["crossings"][name]);
  }
}

TEST_F(InteriorProgram, TakesEitherOrientationAndAClosingVertex) {
  write("clockwise", "0 0\n0 1\n1 1\n1 0\n0 0\n");
  write_curve("other", box(0.5, 0.5, 1.5, 1.5));
  const Json result = interior({"clockwise", "other"});
  EXPECT_EQ(result["inputs"][0]["points"], 4);
  EXPECT_EQ(result["inputs"][0]["orientation"], "clockwise");
  EXPECT_EQ(result["areas"]["intersection"], 0.25);
}

TEST_F(InteriorProgram, TellsWhatItCostsNotToSplitSegments) {
  const Json split = interior({"c1", "c2"}), plain = interior({"c1", "c2", "--method", "ends"});
  EXPECT_EQ(plain["options"]["method"], "ends");
  EXPECT_FALSE(split["error"].contains("splitting"));
  for (const auto& [name, area] : plain["areas"].items()) {
    EXPECT_EQ(plain["error"]["splitting"][name], std::abs(area.get<double>() - split["areas"][name].get<double>()));
  }
  EXPECT_GT(plain["error"]["splitting"]["union"], 1e-7);
  const Json dense = interior({"c1", "c2", "--method", "ends", "--passes", "3", "--points", "10"});
  EXPECT_EQ(dense["options"]["passes"], 3);
  EXPECT_EQ(dense["options"]["points"], 10);
  EXPECT_GT(dense["statistics"]["points_inserted"], 100);
  EXPECT_LT(dense["error"]["splitting"]["union"], 0.01 * plain["error"]["splitting"]["union"].get<double>());
  EXPECT_EQ(interior({"c1", "c2", "--method", "ends", "--passes", "0", "--points", "0"})["areas"], plain["areas"]);
}

TEST_F(InteriorProgram, HasTheSameBytesForAnyNumberOfThreads) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--method", "ends", "--passes", "3", "--points", "7"}}) {
    std::set<std::string> seen;
    for (const char* threads : {"1", "2", "7"}) {
      std::vector<std::string> arguments{"interior", "c1", "c2", "--threads", threads, "--json", "-"};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Outcome outcome = run(arguments);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      seen.insert(outcome.out.substr(0, outcome.out.rfind("\"timing\"")));
    }
    EXPECT_EQ(seen.size(), 1U);
  }
}

TEST_F(InteriorProgram, PrintsAShortTable) {
  const Outcome split = run({"interior", "c1", "c2"}), plain = run({"interior", "c1", "c2", "--method", "ends"});
  EXPECT_EQ(split.err, "");
  EXPECT_NE(split.out.find("Q1 "), std::string::npos) << split.out;
  EXPECT_NE(split.out.find("delta "), std::string::npos) << split.out;
  EXPECT_EQ(split.out.find("splitting"), std::string::npos) << split.out;
  EXPECT_NE(plain.out.find("splitting"), std::string::npos) << plain.out;
  EXPECT_LT(std::count(split.out.begin(), split.out.end(), '\n'), 20);
}

}  // namespace
}  // namespace lober::cli
