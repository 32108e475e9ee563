// `lober levels`: streamlines, potential, Hill's region; and the pictures with labels and windows.
#include <algorithm>
#include <set>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

using LevelsProgram = ProgramTest;

TEST_F(LevelsProgram, DrawsTheSeparatrix) {
  const Outcome outcome = run({"levels", "ovp", "--param", "eps=0", "--box=-3,-3,3,3", "--number", "6", "--grid",
                               "90,80", "-o", "lines.dat", "--svg", "lines.svg", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["levels"].size(), 7U);
  ASSERT_EQ(json["saddles"].size(), 2U);
  std::size_t through = 0;
  for (const Json& level : json["levels"]) through += level["saddle"].is_null() ? 0U : 1U;
  EXPECT_EQ(through, 1U);
  EXPECT_NE(read("lines.dat").find("ZONE T=\"energy 0 curve 0"), std::string::npos);
  EXPECT_NE(read("lines.svg").find("through a saddle, H = 0"), std::string::npos);
}

// Closed curves are polygons beside open ones.
TEST_F(LevelsProgram, WritesPolygonsAndLines) {
  const auto count = [&](const std::string& file, const std::string& word) {
    const std::string text = "\n" + read(file);  // words at the beginning of a line
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
  };
  for (const char* const file : {"levels.dat", "levels.wkt"}) {
    const Outcome outcome = run({"levels", "pendulum", "--grid", "60,50", "-o", file});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  const std::size_t closed = count("levels.dat", " closed\""), open = count("levels.dat", " open\"");
  EXPECT_GT(closed, 0U);
  EXPECT_GT(open, 0U);
  EXPECT_EQ(count("levels.wkt", "\nPOLYGON (("), closed);
  EXPECT_EQ(count("levels.wkt", "\nLINESTRING ("), open);
}

// Below the saddles the well is closed, above them it is not.
TEST_F(LevelsProgram, FindsHillsRegion) {
  const auto closed = [&](const char* energy) {
    const Outcome outcome =
        run({"levels", "capsize", "--energy", energy, "--box=-1.8,-0.8,1.8,1.4", "--json", "-", "--svg", "hill.svg"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(read("hill.svg").find("no motion"), std::string::npos);
    return Json::parse(outcome.out)["levels"][0]["closed"].get<int>();
  };
  EXPECT_EQ(closed("0.22"), 1);
  EXPECT_EQ(closed("0.28"), 0);
}

TEST_F(LevelsProgram, HasTheSameBytesForAnyThreads) {
  std::set<std::string> seen;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = run({"levels", "pcr3bp", "--at", "-1.52,-1.51", "--grid", "100,100", "--threads", threads,
                                 "-o", "l.dat", "--svg", "l.svg", "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    seen.insert(without_timing(outcome.out) + read("l.dat") + read("l.svg"));
  }
  EXPECT_EQ(seen.size(), 1U);
}

TEST_F(LevelsProgram, RefusesWhatMakesNoSense) {
  const auto refused = [&](std::vector<std::string> arguments, const std::string& words) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused({"levels", "henon"}, "is a map");
  refused({"levels", "duffing", "--param", "delta=0.1"}, "no Hamiltonian");
  refused({"levels", "duffing", "--energy", "0.1"}, "two degrees of freedom");
  refused({"levels", "capsize", "--energy", "0.2", "--at", "0.1"}, "cannot be given together");
  refused({"levels", "ovp", "--box", "0,0,1,0"}, "x0 < x1");
  refused({"levels", "ovp", "--grid", "0,5"}, "--grid");
  refused({"levels", "ovp", "-o", "l.npy"}, "Tecplot");
  refused({"levels", "ovp", "--at", "nan"}, "--at");
}

TEST_F(LevelsProgram, PicturesTakeLabelsAndWindows) {
  ASSERT_EQ(run({"tangle", "--system", "ovp", "--before", "2", "--after", "1", "--tolerance", "1e-3", "--labels",
                 "--svg", "labels.svg"})
                .status,
            0);
  const std::string labels = read("labels.svg");
  for (const char* text : {">R<", ">L<", ">p<", ">q<", "f<tspan", "(q)", "4 sips", "7 pips"}) {
    EXPECT_NE(labels.find(text), std::string::npos) << text;
  }
  ASSERT_EQ(run({"overlay", std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat#C1",
                 std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat#C2", "--classes", "--window", "2,-1,4,1",
                 "--svg", "classes.svg"})
                .status,
            0);
  const std::string classes = read("classes.svg");
  EXPECT_NE(classes.find("class 1 {p2, p3, p4, p5}, half the sum of S 5"), std::string::npos);
  EXPECT_NE(classes.find("clip-path=\"url(#plot)\""), std::string::npos);
  ASSERT_EQ(run({"interior", std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat#C1",
                 std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat#C2", "--svg", "paths.svg"})
                .status,
            0);
  EXPECT_NE(read("paths.svg").find("Q2 = 57"), std::string::npos);
  const Outcome wrong = run({"tangle", "--system", "ovp", "--window", "1,0,0,1", "--svg", "w.svg"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("--window"), std::string::npos) << wrong.err;
  EXPECT_EQ(run({"tangle", "--system", "ovp", "--labels"}).status, 2);
}

// Between two points of rest on the zero-velocity curve, through the neighbourhood of the saddle.
TEST_F(LevelsProgram, DrawsPeriodicOrbits) {
  const std::vector<std::string> levels{"levels", "capsize", "--box=-1.8,-0.8,1.8,1.4", "--periodic-orbits"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), levels.begin(), levels.end());
    return run(more);
  };
  ASSERT_EQ(with({"--energy", "0.25307", "--data", "o.csv", "--picture", "o.svg"}).status, 0);
  std::istringstream lines(read("o.csv"));
  double farthest = 0;
  std::size_t points = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("periodic orbits,1,")) continue;
    ++points;
    farthest = std::max(farthest, std::stod(line.substr(line.find(",,") + 2)));
  }
  EXPECT_EQ(points, 256U);
  // The farthest of points at equal times, next to the point of rest.
  EXPECT_NEAR(farthest, 1.0203846889635231911, 2e-6);
  EXPECT_NE(read("o.svg").find("periodic orbits"), std::string::npos);
  const Outcome below = with({"--energy", "0.2", "--picture", "o.svg"});
  EXPECT_EQ(below.status, 0);
  EXPECT_NE(below.err.find("not above that of a saddle"), std::string::npos) << below.err;
  EXPECT_EQ(with({"--picture", "o.svg"}).status, 2);  // needs an energy
}

}  // namespace
}  // namespace lober::cli
