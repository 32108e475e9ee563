// `lober overlay --rule`: curves that cross themselves.

#include <set>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class OverlayRule : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("eight", std::vector<Point>{{-2, -1}, {2, 1}, {2, -1}, {-2, 1}});
    write_curve("box", box(1, -2, 3, 2));
  }
  [[nodiscard]] Json by_rule(const char* rule) const { return overlay({"eight", "box", "--rule", rule}); }
};

TEST_F(OverlayRule, HasTheMembersOfTheContract) {
  const Json result = by_rule("nonzero");
  std::set<std::string> names;
  for (const auto& [name, value] : result.items()) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"program", "command", "inputs", "options", "rule", "arrangement", "winding",
                                          "areas", "pieces", "error", "statistics", "timing", "agreement",
                                          "disagreements", "signed_areas", "q1", "q2", "q3"}));
  EXPECT_EQ(result["rule"], "nonzero");
  EXPECT_EQ(result["inputs"][0]["area"], 0.0);
  EXPECT_EQ(result["inputs"][0]["orientation"], "degenerate");
  EXPECT_EQ(result["inputs"][1]["area"], 8.0);
  EXPECT_EQ(result["arrangement"]["meetings"]["c1"], 1);
  EXPECT_EQ(result["arrangement"]["meetings"]["c2"], 0);
  EXPECT_EQ(result["arrangement"]["meetings"]["c1_c2"], 2);
  EXPECT_EQ(result["arrangement"]["nodes"], 3);
  EXPECT_EQ(result["arrangement"]["faces"], 5);
}

TEST_F(OverlayRule, TellsTheAreaOfEachPairOfWindingNumbers) {
  const Json expected = Json::parse(R"([{"c1":-1,"c2":0,"area":0.5},{"c1":-1,"c2":1,"area":1.5},
                                        {"c1":0,"c2":1,"area":6.5},{"c1":1,"c2":0,"area":2.0}])");
  EXPECT_EQ(by_rule("evenodd")["winding"], expected);
}

TEST_F(OverlayRule, DecidesWhatIsInside) {
  const Json nonzero = by_rule("nonzero"), positive = by_rule("positive"), negative = by_rule("negative");
  EXPECT_EQ(nonzero["areas"]["c1"], 4.0);
  EXPECT_EQ(nonzero["areas"]["intersection"], 1.5);
  EXPECT_EQ(nonzero["pieces"]["c1_minus_c2"].size(), 2U);
  EXPECT_EQ(positive["areas"]["c1"], 2.0);
  EXPECT_EQ(positive["areas"]["intersection"], 0.0);
  EXPECT_EQ(positive["error"]["rounding"]["intersection"], 0.0);
  EXPECT_EQ(negative["areas"]["c2"], 0.0);
  EXPECT_EQ(negative["pieces"]["union"].size(), 1U);
  EXPECT_EQ(negative["pieces"]["union"][0]["area"], 2.0);
}

TEST_F(OverlayRule, AgreesWithTheOverlayOfSimpleCurves) {
  write_curve("c1", flower(3000, 31, 0.1, {0, 0}));
  write_curve("c2", flower(2000, 17, 0.2, {0.05, 0.02}));
  const Json simple = overlay({"c1", "c2"}), ruled = overlay({"c1", "c2", "--rule", "nonzero"});
  for (const auto& [name, area] : simple["areas"].items()) {
    EXPECT_NEAR(area.get<double>(), ruled["areas"][name].get<double>(), 1e-15) << name;
  }
  for (const auto& [name, pieces] : simple["pieces"].items()) EXPECT_EQ(pieces.size(), ruled["pieces"][name].size());
}

TEST_F(OverlayRule, WritesLobes) {
  const Outcome outcome = run({"overlay", "eight", "box", "--rule", "nonzero", "--lobes", "lobes.dat"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string lobes = read("lobes.dat");
  EXPECT_NE(lobes.find("c1_minus_c2 1 area="), std::string::npos);
  EXPECT_NE(lobes.find("c2_minus_c1 0 area=6.5"), std::string::npos);
  EXPECT_NE(outcome.out.find("C1 winds"), std::string::npos);
}

TEST_F(OverlayRule, LeavesOutPiecesWhenTotalsAreAskedFor) {
  EXPECT_FALSE(overlay({"eight", "box", "--rule", "nonzero", "--areas-only"}).contains("pieces"));
}

TEST_F(OverlayRule, HasTheSameBytesForAnyNumberOfThreads) {
  write_curve("c1", flower(30000, 31, 1.5, {0, 0}));  // so deep that the petals cross
  write_curve("c2", flower(20000, 17, 1.2, {0.05, 0.02}));
  std::set<std::string> seen;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = run({"overlay", "c1", "c2", "--rule", "evenodd", "--threads", threads, "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    seen.insert(outcome.out.substr(0, outcome.out.rfind("\"timing\"")));
  }
  EXPECT_EQ(seen.size(), 1U);
}

TEST_F(OverlayRule, RefusesWhatDoesNotCombine) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--crossings", "crossings.csv"}, {"--no-check-simple"}}) {
    std::vector<std::string> arguments{"overlay", "eight", "box", "--rule", "nonzero"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(more[0] + " and --rule cannot be given together"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  }
  const Outcome unknown = run({"overlay", "eight", "box", "--rule", "odd"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("odd"), std::string::npos);
}

TEST_F(OverlayRule, OfTheInteriorMethodGivesTheSameAreas) {
  write_curve("c1", flower(3000, 31, 1.5, {0, 0}));  // so deep that the petals cross
  write_curve("c2", flower(2000, 17, 1.2, {0.05, 0.02}));
  for (const char* rule : {"nonzero", "evenodd", "positive", "negative"}) {
    for (const auto& [first, second] : {std::pair{"eight", "box"}, {"c1", "c2"}, {"c1", "eight"}}) {
      const Json found = interior({first, second, "--rule", rule}), other = overlay({first, second, "--rule", rule});
      for (const char* member : {"areas", "winding", "arrangement", "inputs"}) {
        EXPECT_EQ(found[member], other[member]) << rule << ' ' << first << ' ' << member;
      }
      EXPECT_EQ(found["q1"], found["areas"]["symmetric_difference"]);
      EXPECT_EQ(found["q2"], found["areas"]["union"]);
      EXPECT_EQ(found["q3"], found["areas"]["intersection"]);
      EXPECT_EQ(found["rule"], rule);
    }
  }
  const Outcome text = run({"interior", "eight", "box", "--rule", "nonzero"});
  EXPECT_NE(text.out.find("Q1 9, Q2 10.5, Q3 1.5"), std::string::npos) << text.out;
  // Simple curves: by the integrals along both curves, and by faces of the arrangement.
  write_curve("s1", flower(3000, 31, 0.1, {0, 0}));
  write_curve("s2", flower(2000, 17, 0.2, {0.05, 0.02}));
  const Json integrals = interior({"s1", "s2"}), faces = interior({"s1", "s2", "--rule", "positive"});
  for (const auto& [name, area] : integrals["areas"].items()) {
    EXPECT_NEAR(area.get<double>(), faces["areas"][name].get<double>(),
                integrals["error"]["rounding"][name].get<double>() + faces["error"]["rounding"][name].get<double>());
  }
}

TEST_F(OverlayRule, OfTheInteriorMethodTakesNoOptionsOfTheIntegrals) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--method", "ends"}, {"--passes", "2"}, {"--verify"}, {"--no-check-simple"}}) {
    std::vector<std::string> arguments{"interior", "eight", "box", "--rule", "nonzero"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("--rule"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(more[0]), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run({"interior", "eight", "box", "--rule", "odd"}).status, 2);
}

TEST_F(OverlayRule, IsNamedWhenACurveIsNotSimple) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"interior", "eight", "box"},
                                                  {"eight", "box", "out"},
                                                  {"-light", "eight", "box", "out", "-DENS", "2", "3"}}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("--rule"), std::string::npos) << outcome.err;
  }
  const Outcome outcome = run({"overlay", "eight", "box"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("--rule"), std::string::npos);
}

}  // namespace
}  // namespace lober::cli
