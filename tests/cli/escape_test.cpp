// `lober escape`.

#include <array>
#include <cmath>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

class EscapeProgram : public ProgramTest {};

TEST_F(EscapeProgram, WritesTheTable) {
  const Outcome outcome = run({"escape", "capsize", "--energy", "0.25307", "--crossings", "3", "--tolerance", "1e-4",
                               "--json", "table.json", "--svg", "curves.svg", "--monte-carlo", "2000"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("   3  left       right  "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("DISAGREEMENT"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("11.1522"), std::string::npos);
  EXPECT_NE(outcome.out.find("standard errors"), std::string::npos);
  const Json result = Json::parse(read("table.json"));
  EXPECT_EQ(result["command"], "escape");
  EXPECT_EQ(result["bottlenecks"].size(), 2U);
  EXPECT_NEAR(result["bottlenecks"][0]["orbit"]["period"].get<double>(), 3.189752742896737111, 1e-12);
  EXPECT_EQ(result["table"].size(), 12U);
  EXPECT_EQ(result["monte_carlo"]["trajectories"], 2000);
  EXPECT_EQ(result["agreement"], true);
  ASSERT_TRUE(result.contains("stop"));
  EXPECT_EQ(result["stop"], nullptr);
  double found = 0;
  for (const Json& row : result["table"]) {
    if (row["entrance"] == "left" && row["exit"] == "right" && row["crossings"] == 3) found = row["fraction"];
  }
  EXPECT_NEAR(found, 0.111522124886, 1e-6);
  EXPECT_TRUE(read("curves.svg").starts_with("<svg"));
}

// The overlap of an image of the entrance with a pre-image of the exit is the fraction, whichever two are taken.
TEST_F(EscapeProgram, WritesCurvesThatGiveTheTable) {
  const Outcome outcome = run({"escape", "capsize", "--energy", "0.25307", "--crossings", "3", "--tolerance", "1e-5",
                               "--monte-carlo", "0", "--curves", "curves.dat"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto fraction = [&](const std::string& from, const std::string& to) {
    const Json areas = overlay({"curves.dat#" + from, "curves.dat#" + to, "--areas-only"})["areas"];
    return areas["intersection"].get<double>() / areas["c1"].get<double>();
  };
  EXPECT_NEAR(fraction("entrance left f^2", "exit right f^-2"), 0.111522124886, 1e-4);
  EXPECT_NEAR(fraction("entrance left f^3", "exit right f^-1"), 0.111522124886, 1e-4);
  EXPECT_NEAR(fraction("entrance left f^2", "exit left f^-3"), 0.029905210198, 1e-4);
  EXPECT_EQ(fraction("entrance left", "exit right"), 0);
  EXPECT_NE(read("curves.dat").find("orbit left"), std::string::npos);
  ASSERT_EQ(run({"escape", "capsize", "--energy", "0.25307", "--crossings", "2", "--tolerance", "1e-4", "--monte-carlo",
                 "0", "--curves", "curves.geojson"})
                .status,
            0);
  for (const Json& feature : Json::parse(read("curves.geojson"))["features"]) {
    const std::string name = feature["properties"]["name"];
    EXPECT_EQ(feature["geometry"]["type"], name.starts_with("orbit") ? "LineString" : "Polygon") << name;
  }
  const Outcome refused = run({"escape", "capsize", "--curves", "curves.npy"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--curves writes several curves"), std::string::npos) << refused.err;
}

// Every vertex lies on the surface of the energy, at least on the side of the tube where its ring on the section is.
TEST_F(EscapeProgram, WritesTubesAsSurfaces) {
  const Outcome outcome = run({"escape", "capsize", "--energy", "0.28", "--crossings", "0", "--tubes", "tubes.vtk"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream text(read("tubes.vtk"));
  std::string word;
  for (int line = 0; line < 4; ++line) std::getline(text, word);
  EXPECT_EQ(word, "DATASET POLYDATA");
  std::size_t points = 0, quads = 0, numbers = 0;
  text >> word >> points >> word;
  ASSERT_GT(points, 1000U);
  std::vector<std::array<double, 4>> states(points);
  for (auto& state : states) text >> state[0] >> state[1] >> state[2];
  text >> word >> quads >> numbers;
  EXPECT_EQ(word, "POLYGONS");
  EXPECT_EQ(numbers, 5 * quads);
  for (std::size_t k = 0; k < quads; ++k) {
    std::size_t count = 0;
    text >> count;
    ASSERT_EQ(count, 4U);
    for (int corner = 0; corner < 4; ++corner) {
      std::size_t index = 0;
      text >> index;
      ASSERT_LT(index, points);
    }
  }
  while (text >> word && word != "default") {
  }
  double nearest = 1, farthest = 0;
  for (auto& state : states) {
    text >> state[3];
    const auto [x, y, vy, vx] = state;
    const double energy = 0.5 * vx * vx + vy * vy / (1.6 * 1.6) + 0.5 * x * x + y * y - x * x * y;
    EXPECT_NEAR(energy, 0.28, 1e-9);
    nearest = std::min(nearest, std::fabs(x));
    farthest = std::max(farthest, std::fabs(x));
  }
  // From the section to the orbits at x = +-1.
  EXPECT_EQ(nearest, 0);
  EXPECT_GT(farthest, 0.95);
  EXPECT_LT(farthest, 1.3);
  ASSERT_EQ(run({"escape", "capsize", "--energy", "0.28", "--crossings", "0", "--tubes", "tubes.svg"}).status, 0);
  EXPECT_NE(read("tubes.svg").find("stable tubes: what leaves"), std::string::npos);
  // Trajectories inside the stable tube leave, those outside come back.
  const std::vector<std::string> tubes{"escape",  "capsize",     "--energy",   "0.28",        "--saddle",
                                       "2",       "--crossings", "0",          "--direction", "+",
                                       "--tubes", "one.svg",     "--tubes-of", "stable"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), tubes.begin(), tubes.end());
    return run(more);
  };
  ASSERT_EQ(with({"--trajectory=-0.1,0.28"}).status, 0);
  std::string one = read("one.svg");
  EXPECT_NE(one.find("trajectory that leaves"), std::string::npos);
  EXPECT_EQ(one.find("comes back"), std::string::npos);
  EXPECT_EQ(one.find("unstable tubes"), std::string::npos);
  ASSERT_EQ(with({"--trajectory=0.2,0.4"}).status, 0);
  one = read("one.svg");
  EXPECT_NE(one.find("trajectory that comes back"), std::string::npos);
  EXPECT_EQ(one.find("trajectory that leaves"), std::string::npos);
  const Outcome outside = with({"--trajectory=0.2,4"});
  EXPECT_EQ(outside.status, 1);
  EXPECT_NE(outside.err.find("no point of energy 0.28"), std::string::npos) << outside.err;
  EXPECT_EQ(run({"escape", "capsize", "--crossings", "0", "--tubes", "t.vtk", "--trajectory=-0.1,0.28"}).status, 2);
  const Outcome refused = run({"escape", "capsize", "--tubes", "tubes.dat"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("use one of these endings"), std::string::npos) << refused.err;
}

// The potential of Henon & Heiles is symmetric in x: what enters by one of two mirrored bottlenecks leaves by either as
// what enters by the other.
TEST_F(EscapeProgram, TakesASystemOfTheUser) {
  const Outcome outcome =
      run({"escape", LOBER_EXAMPLES "/henon_heiles.so", "--energy", "0.17", "--crossings", "1", "--tolerance", "1e-4",
           "--saddle", "0.866,-0.5,0,0", "--saddle", "-0.866,-0.5,0,0", "--section", "x=0", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  double left = 0, right = 0;
  for (const Json& row : result["table"]) {
    if (row["fraction"].get<double>() == 0) continue;
    (row["entrance"] == "left" ? left : right) = row["fraction"];
  }
  EXPECT_NEAR(left, 0.5319069, 1e-5);
  EXPECT_NEAR(left, right, 1e-6);
}

// x = 0 passes through the bottleneck of (0, 1). Three bottlenecks are open, of which one is named.
TEST_F(EscapeProgram, NamesTheSaddlesThatBoundTheWell) {
  for (const char* crossings : {"1", "4"}) {
    const Outcome outcome = run({"escape", LOBER_EXAMPLES "/henon_heiles.so", "--saddle", "0,1,0,0", "--energy", "0.18",
                                 "--crossings", crossings});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const char* words : {"the periodic orbit of the bottleneck (0, 1)", "is above that of 3 saddles", "(0.866025",
                              "(-0.866025", "--section"}) {
      EXPECT_NE(outcome.err.find(words), std::string::npos) << words << ": " << outcome.err;
    }
  }
  // With a section within the well the same tube is whole.
  const Outcome within = run({"escape", LOBER_EXAMPLES "/henon_heiles.so", "--saddle", "0,1,0,0", "--energy", "0.18",
                              "--section", "y=-0.2", "--direction", "-", "--crossings", "0"});
  EXPECT_EQ(within.status, 0) << within.err;
}

TEST_F(EscapeProgram, SameBytesForAnyNumberOfThreads) {
  const auto bytes = [&](const char* threads) {
    const Outcome outcome = run({"escape", "capsize", "--crossings", "1", "--tolerance", "1e-3", "--monte-carlo", "500",
                                 "--threads", threads, "--json", "-"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out.substr(0, outcome.out.find("\"timing\""));
  };
  EXPECT_EQ(bytes("1"), bytes("3"));
}

TEST_F(EscapeProgram, EndsWithAReasonBeforeTheNextImageIsTooMuch) {
  const std::vector<std::string> arguments{"escape",      "capsize", "--crossings",  "30",
                                           "--tolerance", "1e-4",    "--max-points", "2000"};
  const Outcome outcome = run(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(" of 30: the next image needs "), std::string::npos) << outcome.out;
  std::vector<std::string> with_json = arguments;
  with_json.insert(with_json.end(), {"--json", "-"});
  const Json result = Json::parse(run(with_json).out);
  EXPECT_EQ(result["stop"]["reason"], "points");
  EXPECT_EQ(result["table"].size(), 4 * result["crossings"].get<std::size_t>());
  EXPECT_GT(result["stop"]["points_ahead"], 2000);
}

TEST_F(EscapeProgram, OrbitsAndTubesOnly) {
  const Outcome outcome = run({"escape", "pcr3bp", "--energy", "-1.515", "--crossings", "0", "--saddle", "2",
                               "--tolerance", "1e-4", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  EXPECT_EQ(result["table"].size(), 0U);
  const Json& bottleneck = result["bottlenecks"][0];
  EXPECT_NEAR(bottleneck["entry_curves"][0]["area"].get<double>() / bottleneck["area"].get<double>(), 1, 1e-5);
}

// Sections that tubes meet more than once between two crossings that count: the table is wrong there.
TEST_F(EscapeProgram, SaysWhereTheSectionDoesNotServe) {
  const auto disagreements = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "d.json"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(outcome.out.find("DISAGREEMENT"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("two routes disagree"), std::string::npos) << outcome.err;
    return Json::parse(read("d.json"))["disagreements"].dump();
  };
  const std::string trajectories = disagreements({"escape", "capsize", "--section", "x=0.3", "--crossings", "2"});
  EXPECT_NE(trajectories.find("\"trajectories\""), std::string::npos) << trajectories;
  const std::string sums =
      disagreements({"escape", "capsize", "--section", "x=0.25", "--crossings", "2", "--monte-carlo", "0"});
  EXPECT_NE(sums.find("what has entered"), std::string::npos) << sums;
  EXPECT_NE(sums.find("what it holds"), std::string::npos) << sums;
  EXPECT_NE(sums.find("what is left of it"), std::string::npos) << sums;
}

// One of two open bottlenecks is named: what leaves by the other is not said to be inside. The orbit of (1, 0.5) is the
// mirror image of that of (-1, 0.5).
TEST_F(EscapeProgram, DoesNotCallInsideWhatMayHaveLeftElsewhere) {
  const std::vector<std::string> arguments{"escape", "capsize",  "--energy", "0.25307",     "--crossings",
                                           "3",      "--saddle", "1",        "--tolerance", "1e-4"};
  const Outcome outcome = run(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("also open         saddle (1, 0.5), energy 0.25"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("still inside"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("not left by these bottlenecks"), std::string::npos) << outcome.out;
  std::vector<std::string> with_json = arguments;
  with_json.insert(with_json.end(), {"--json", "-"});
  EXPECT_EQ(Json::parse(run(with_json).out)["also_open"][0]["at"], (Json{1, 0.5, 0, 0}));
  const Outcome both = run({"escape", "capsize", "--crossings", "1", "--tolerance", "1e-4"});
  EXPECT_NE(both.out.find("still inside"), std::string::npos) << both.out;
  EXPECT_EQ(both.out.find("also open"), std::string::npos) << both.out;
}

// Each names the tube and what can be given instead.
TEST_F(EscapeProgram, SaysWhatToGiveWhereASectionLiesOutsideOfTheWell) {
  for (const char* section : {"y=0.45", "y=0.6", "y=5"}) {
    const Outcome outcome = run({"escape", "capsize", "--section", section, "--tolerance", "1e-4"});
    EXPECT_EQ(outcome.status, 1) << section;
    EXPECT_EQ(outcome.out, "") << section;
    EXPECT_NE(outcome.err.find("is above that of 2 saddles, (-1, 0.5), (1, 0.5)"), std::string::npos) << outcome.err;
  }
  const Outcome closed = run({"escape", "pcr3bp", "--crossings", "0", "--energy", "-1.5195"});
  EXPECT_EQ(closed.status, 2);
  for (const char* words :
       {"the saddle (1.06883, 0)", "energies from about -1.51921836 on", "open are (0.93237, 0)", "(--saddle)"}) {
    EXPECT_NE(closed.err.find(words), std::string::npos) << words << ": " << closed.err;
  }
  const Outcome elsewhere = run({"escape", "pcr3bp", "--crossings", "0", "--energy", "-1.51921"});
  EXPECT_NE(elsewhere.err.find("neither branch of the unstable tube of the bottleneck (0.93237, 0)"), std::string::npos)
      << elsewhere.err;
}

TEST_F(EscapeProgram, NamesTheLimitOnPointsWhereThatIsTheCause) {
  const Outcome outcome = run({"escape", "capsize", "--energy", "0.26", "--max-points", "100"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("takes more points than the limit on points (--max-points) allows"), std::string::npos)
      << outcome.err;
  // Where one of two directions comes late, the tubes are those of the table.
  EXPECT_EQ(run({"escape", "capsize", "--energy", "0.45", "--crossings", "0", "--tolerance", "1e-4"}).status, 0);
}

// A section through the bottleneck meets its orbit, and what runs beside that crosses it again and again.
TEST_F(EscapeProgram, SaysThatASectionCutsAPeriodicOrbit) {
  for (const char* crossings : {"0", "2"}) {
    const Outcome outcome = run({"escape", "capsize", "--section", "y=0.5", "--crossings", crossings});
    EXPECT_EQ(outcome.status, 1) << outcome.out;
    EXPECT_NE(outcome.err.find("cuts the periodic orbit of the bottleneck (-1, 0.5)"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("--section"), std::string::npos) << outcome.err;
  }
}

TEST_F(EscapeProgram, TakesPositionsOfSaddles) {
  const auto table = [&](const char* left, const char* right) {
    const Outcome outcome =
        run({"escape", "capsize", "--crossings", "2", "--tolerance", "1e-4", "--saddle", left, "--saddle", right});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(table("-1.02,0.5", "0.99,0.48"), table("1", "2"));
  const Outcome three = run({"escape", "capsize", "--saddle", "1,2,3"});
  EXPECT_EQ(three.status, 2);
  EXPECT_NE(three.err.find("neither a position X,Y"), std::string::npos) << three.err;
}

// Measuring cut curves takes far longer than following them, which no forecast from earlier images shows.
TEST_F(EscapeProgram, TheBudgetEndsWorkThatTakesLongerThanExpected) {
  const Outcome outcome = run({"escape", "capsize", "--energy", "0.5", "--budget", "2", "--json", "-"});
  EXPECT_NE(outcome.status, 130) << outcome.err;
  const Json result = Json::parse(outcome.out);
  EXPECT_EQ(result["stop"]["reason"], "budget");
  EXPECT_LT(result["stop"]["seconds_spent"], 1.2 * 2 + 0.5);
  // Besides them the row of what leaves before the first crossing that counts.
  EXPECT_EQ(result["table"].size(), 4 * result["crossings"].get<std::size_t>() + 1);
  EXPECT_EQ(result["bottlenecks"].size(), 2U);
}

// Cut curves cross themselves, and those of a section that tubes meet twice do too.
TEST_F(EscapeProgram, PicturesOfCurvesThatCrossThemselves) {
  const Outcome outcome = run({"escape", "capsize", "--section", "x=0.3", "--crossings", "2", "--monte-carlo", "0",
                               "--tolerance", "1e-4", "--json", "t.json", "--svg", "t.svg"});
  EXPECT_EQ(outcome.err.find("not simple"), std::string::npos) << outcome.err;
  EXPECT_EQ(Json::parse(read("t.json"))["crossings"], 2);
  EXPECT_NE(read("t.svg").find("</svg>"), std::string::npos);
}

TEST_F(EscapeProgram, SaysWhichEnergiesWork) {
  const auto fails = [&](const char* energy, int status) {
    const Outcome outcome = run({"escape", "capsize", "--energy", energy});
    EXPECT_EQ(outcome.status, status) << outcome.err;
    for (const char* words : {energy, "saddle (-1, 0.5), 0.25", "energies from about 0.250000125"}) {
      EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
  };
  fails("0.2500000001", 1);
  fails("0.24", 2);
  EXPECT_EQ(run({"escape", "capsize", "--energy", "0.250000126", "--crossings", "1"}).status, 0);
}

TEST_F(EscapeProgram, RefusesWhatMakesNoSense) {
  const auto fails = [&](std::vector<std::string> arguments, int status, std::string_view words) {
    arguments.insert(arguments.begin(), "escape");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  fails({}, 2, "SYSTEM");
  fails({"nothing"}, 2, "nothing");
  fails({"henon"}, 2, "flow");
  fails({"capsize", "--energy", "0.2"}, 2, "above that of the saddle");
  fails({"capsize", "--energy", "0.26", "--param", "energy=0.26"}, 2, "twice");
  fails({"capsize", "--param", "R"}, 2, "--param");
  fails({"capsize", "--saddle", "3"}, 2, "--saddle");
  fails({"capsize", "--saddle", "1,2,3"}, 2, "--saddle");
  fails({"capsize", "--saddle", "0.01,0.01,0,0"}, 1, "rank 1");
  fails({"capsize", "--section", "z=0"}, 2, "--section");
  fails({"capsize", "--direction", "both"}, 2, "direction");
  fails({"pcr3bp"}, 2, "give --section");
  // Through a mass: what collides does not arrive, and no number of points makes the curve closed.
  fails({"pcr3bp", "--energy", "-1.518", "--section", "x=1", "--crossings", "1"}, 1, "does not reach the section");
  fails({"capsize", "--crossings", "0", "--monte-carlo", "5"}, 2, "--monte-carlo");
  fails({"capsize", "--svg", "nowhere/file"}, 1, "nowhere/file");
}

}  // namespace
}  // namespace lober::cli
