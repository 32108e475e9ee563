// `lober section`: orbits as a file and as a picture.
#include <cmath>
#include <cstring>
#include <set>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

using SectionProgram = ProgramTest;

TEST_F(SectionProgram, WritesOrbits) {
  const Outcome outcome = run({"section", "henon", "--start", "0.5,0", "-0.2,0.1", "--iterates", "2", "--param",
                               "k=0.25", "-o", "orbits.npy", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["options"]["orbits"], 2);
  EXPECT_EQ(json["points"], 6);
  EXPECT_EQ(json["lost_orbits"], 0);
  const std::string npy = read("orbits.npy");
  EXPECT_NE(npy.find("'shape': (2, 3, 2), }"), std::string::npos) << npy.substr(10, 100);
  ASSERT_EQ(npy.size(), 128U + 2 * 3 * 2 * 8);
  std::vector<double> numbers(12);
  std::memcpy(numbers.data(), npy.data() + 128, 96);
  // (x, y) -> (x^2 - k - y, x)
  EXPECT_EQ(numbers, (std::vector<double>{0.5, 0, 0, 0.5, -0.75, 0, -0.2, 0.1, -0.2 * -0.2 - 0.25 - 0.1, -0.2,
                                          numbers[10], numbers[8]}));
  ASSERT_EQ(
      run({"section", "henon", "--start", "0.5,0", "--iterates", "2", "--param", "k=0.25", "-o", "orbits.csv"}).status,
      0);
  EXPECT_EQ(read("orbits.csv"), "orbit,iterate,x,y\n0,0,0.5,0\n0,1,0,0.5\n0,2,-0.75,0\n");
}

TEST_F(SectionProgram, FoldsAnglesUnlessLifted) {
  const auto largest = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"section", "pendulum", "--start", "0,2.4", "--iterates", "20", "-o", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    double most = 0;
    std::istringstream lines(outcome.out);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
      most = std::max(most, std::stod(line.substr(line.find(',', line.find(',') + 1) + 1)));
    return most;
  };
  EXPECT_LT(largest({}), 4);
  EXPECT_GT(largest({"--lifted"}), 50);
}

TEST_F(SectionProgram, DrawsTheDensity) {
  const Outcome outcome = run({"section", "standard", "--orbits", "50", "--iterates", "200", "--svg", "section.svg"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("points     10050"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("folded     by shifts of (6.28318"), std::string::npos) << outcome.out;
  EXPECT_NE(read("section.svg").find("1 point a cell"), std::string::npos);
  const Outcome leaving = run({"section", "capsize", "--orbits", "30", "--iterates", "100"});
  EXPECT_NE(leaving.out.find("left "), std::string::npos) << leaving.out;
}

TEST_F(SectionProgram, HasTheSameBytesForAnyNumberOfThreads) {
  std::set<std::string> seen;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = run({"section", "duffing", "--orbits", "100", "--iterates", "30", "--threads", threads,
                                 "-o", "orbits.npy", "--svg", "section.svg", "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    seen.insert(without_timing(outcome.out) + read("orbits.npy") + read("section.svg"));
  }
  EXPECT_EQ(seen.size(), 1U);
}

// Two of the corners lie where the energy does not reach: they are no orbits, and not points of the section either.
TEST_F(SectionProgram, CountsStartsThatTheEnergyDoesNotReachApart) {
  const Outcome outcome = run({"section", "capsize", "--param", "energy=0.22", "--start", "0,0", "0.46,0.74",
                               "0.46,-0.74", "--iterates", "10", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["unreached_starts"], 2);
  EXPECT_EQ(json["lost_orbits"], 0);
  EXPECT_EQ(json["points"], 11);
  const Outcome table = run({"section", "capsize", "--param", "energy=0.22", "--start", "0.46,0.74"});
  ASSERT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("no orbit   1 of the starts"), std::string::npos) << table.out;
  EXPECT_EQ(table.out.find("left "), std::string::npos) << table.out;
}

// Both coordinates of the ABC flow's section are angles; half of the starts lie where the flow falls.
TEST_F(SectionProgram, FoldsTwoAngles) {
  const Outcome outcome = run({"section", "abc", "--orbits", "40", "--iterates", "50", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_GT(json["options"]["second_lattice"][1], 6.28);
  EXPECT_GT(json["unreached_starts"], 10);
  EXPECT_LT(json["unreached_starts"], 30);
  EXPECT_EQ(json["points"], json["points_in_box"]);
  const Outcome table = run({"section", "abc", "--orbits", "10", "--iterates", "5", "--svg", "abc.svg"});
  EXPECT_NE(table.out.find("and (0, 6.28318"), std::string::npos) << table.out;
  // A map that preserves a flux and no area has no transport of areas.
  const Outcome refused = run({"transport", "abc"});
  EXPECT_NE(refused.status, 0);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
}

// The part of U1 that leaves after its first crossing is what two tubes of known area cut from it: 2 (R^2/2) J of pi e
// R.
TEST_F(SectionProgram, TellsWhenOrbitsLeave) {
  const Outcome outcome =
      run({"section", "capsize", "--exit-times", "--iterates", "3", "--svg", "exit.svg", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  const Json& times = json["exit_times"];
  ASSERT_GE(times["leaving"].size(), 2U);
  double leaving = 0;
  for (const Json& row : times["leaving"]) leaving += row["orbits"].get<double>();
  EXPECT_EQ(leaving, json["lost_orbits"].get<double>());
  const double all = leaving + times["staying"].get<double>();
  EXPECT_EQ(all + json["unreached_starts"].get<double>(), times["columns"].get<double>() * times["rows"].get<double>());
  const double expected = 2 * 0.012534801639697775517 / (std::acos(-1.0) * 0.25307 * 1.6);
  EXPECT_NEAR(times["leaving"][0]["orbits"].get<double>() / all, expected, 0.03 * expected);
  EXPECT_NE(read("exit.svg").find("leaves after crossing 2"), std::string::npos);
  const Outcome table = run({"section", "capsize", "--exit-times", "--iterates", "1", "--svg", "exit.svg"});
  EXPECT_NE(table.out.find("leave      after crossing 1: "), std::string::npos) << table.out;
}

TEST_F(SectionProgram, RefusesWhatMakesNoSense) {
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& words) {
    arguments.insert(arguments.begin(), "section");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused({"henon", "--orbits", "0"}, 2, "--orbits");
  refused({"henon", "--iterates", "0"}, 2, "--iterates");
  refused({"henon", "--orbits", "5", "--start", "0,0"}, 2, "cannot be given together");
  refused({"henon", "--start", "nan,0"}, 2, "--start: nan,0 is not a finite point");
  refused({"henon", "--start", "nowhere"}, 1, "nowhere: ");
  refused({"henon", "--box", "0,0,1,0"}, 2, "x0 < x1");
  refused({"henon", "-o", "orbits.dat"}, 2, "use one of these endings");
  refused({"capsize", "--exit-times"}, 2, "--picture");
  refused({"capsize", "--exit-times", "--svg", "a.svg", "--start", "0,0"}, 2, "cannot be given together");
  refused({"nosuch"}, 2, "nosuch");
}

}  // namespace
}  // namespace lober::cli
