// `lober grow` as a user runs it.

#include <algorithm>
#include <cmath>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class Grow : public ProgramTest {
 protected:
  Outcome grow(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "grow");
    return run(arguments);
  }
  nlohmann::json json(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = grow(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
  void expect_failure(const std::vector<std::string>& arguments, int status, std::string_view words) {
    const Outcome outcome = grow(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
};

TEST_F(Grow, StandardMapIntoEveryFormat) {
  const std::vector<std::string> common{"standard",   "--param",    "K=1.2", "--from",      "0.1,0",
                                        "--unstable", "--iterates", "4",     "--tolerance", "1e-4"};
  std::vector<Point> first;
  for (const char* name : {"u.npy", "u.csv", "u.txt", "u.dat", "u.raw"}) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), {"-o", name});
    const Outcome outcome = grow(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("multiplier           2.8489995996796"), std::string::npos) << outcome.out;
    const std::vector<Point> points = read_curve_file(folder() / name).zones[0].points;
    EXPECT_GT(points.size(), 100U);
    if (first.empty()) first = points;
    EXPECT_EQ(points, first) << name;
  }
}

TEST_F(Grow, SaysWhyItEndedEarly) {
  const std::vector<std::string> common{"standard",    "--from", "0.1,0", "--unstable",
                                        "--tolerance", "1e-4",   "-o",    "u.npy"};
  const auto ended = [&](const std::vector<std::string>& further, const std::string& words) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), further.begin(), further.end());
    const Outcome outcome = grow(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, words.empty() ? "" : "lober: growing ended " + words + "\n");
    EXPECT_EQ(outcome.out.find("before what was asked") != std::string::npos, !words.empty()) << outcome.out;
  };
  ended({"--iterates", "2"}, "");
  ended({"--length", "20"}, "");
  ended({"--iterates", "12", "--max-points", "3000"},
        "at a limit, of --max-points or --memory, before what was asked for");
}

TEST_F(Grow, Json) {
  const nlohmann::json result = json({"henon", "--param", "k=0.5", "--from", "2.2,2.2", "--stable", "--branch", "-",
                                      "--length", "30", "--tolerance", "1e-5", "--box", "-5,-5,5,5", "-o", "s.npy"});
  EXPECT_EQ(result["command"], "grow");
  EXPECT_EQ(result["system"]["parameters"]["k"], 0.5);
  EXPECT_EQ(result["options"]["side"], "stable");
  EXPECT_NEAR(result["local_manifold"]["saddle"][0].get<double>(), 1 + std::sqrt(1.5), 1e-14);
  EXPECT_NEAR(result["local_manifold"]["multiplier"].get<double>(), 4.212077189549, 1e-10);
  EXPECT_EQ(result["result"]["stop"], "length");
  EXPECT_GE(result["result"]["length"].get<double>(), 30);
  EXPECT_EQ(result["result"]["points"], read_curve_file(folder() / "s.npy").zones[0].points.size());
  EXPECT_FALSE(result["diagnostics"]["list"].empty());
  EXPECT_EQ(result["diagnostics"]["list"][0]["cause"], "left-box");
}

TEST_F(Grow, FlowsAndThreads) {
  const std::vector<std::string> common{"ovp",      "--param", "gamma=0.5",  "--from", "1.45,0",      "--unstable",
                                        "--branch", "-",       "--iterates", "2",      "--tolerance", "1e-4"};
  for (const char* threads : {"1", "7"}) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), {"--threads", threads, "-o", std::string("u") + threads + ".raw"});
    EXPECT_EQ(grow(arguments).status, 0);
  }
  EXPECT_GT(read("u1.raw").size(), 1000U);
  EXPECT_EQ(read("u1.raw"), read("u7.raw"));
}

TEST_F(Grow, FindsTheSaddleItself) {
  const nlohmann::json result = json({"henon", "--unstable", "--iterates", "0", "--tolerance", "1e-4"});
  EXPECT_NEAR(result["local_manifold"]["saddle"][0].get<double>(), 1 + std::sqrt(1.5), 1e-14);
  expect_failure({"double-gyre", "--period", "2", "--unstable", "--iterates", "0", "--tolerance", "1e-4"}, 2,
                 "several saddles");
  expect_failure({"henon", "--unstable", "--iterates", "0", "--branch", "0,0"}, 2, "a branch is +, - or a vector");
}

// By default the two sides are those of one tangle, to its tolerance: heteroclinic, and homoclinic from files of which
// each says by itself where the saddle is.
TEST_F(Grow, BothSidesOfATangleByNameAlone) {
  struct Case {
    const char *system, *parameter;
    double lobe;
  };
  for (const Case& known : {Case{"ovp", "gamma=0.5", 0.2541062770995}, Case{"duffing", "omega=2", 0.0764657750801}}) {
    for (const char* side : {"--unstable", "--stable"}) {
      const Outcome outcome = grow({known.system, "--param", known.parameter, side, "--iterates", "2", "-o",
                                    std::string("curve") + side + ".npy"});
      ASSERT_EQ(outcome.status, 0) << outcome.err;
    }
    const Outcome outcome = run({"tangle", "curve--unstable.npy", "curve--stable.npy", "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json lobes = nlohmann::json::parse(outcome.out)["lobes"];
    ASSERT_GE(lobes.size(), 2U) << known.system;
    for (const nlohmann::json& lobe : lobes) {
      EXPECT_NEAR(std::fabs(lobe["area"].get<double>()), known.lobe, 1e-5) << known.system;
    }
  }
}

TEST_F(Grow, Refuses) {
  const std::vector<std::string> good{"standard",   "--from", "0,0",         "--unstable",
                                      "--iterates", "2",      "--tolerance", "1e-4"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), good.begin(), good.end());
    return more;
  };
  EXPECT_EQ(grow(good).status, 0);
  expect_failure({"standard", "--from", "0,0", "--iterates", "2", "--tolerance", "1e-4"}, 2, "--unstable or --stable");
  expect_failure({"standard", "--from", "0,0", "--unstable", "--tolerance", "1e-4"}, 2, "--iterates or --length");
  expect_failure({"standard", "--from", "3.14,0", "--unstable", "--iterates", "2", "--tolerance", "1e-4"}, 1,
                 "is not a saddle");
  expect_failure({"henon", "--param", "k=-3", "--from", "0,0", "--unstable", "--iterates", "2", "--tolerance", "1e-4"},
                 1, "(0, 0)");
  expect_failure({"nosuch", "--from", "0,0", "--unstable", "--iterates", "2", "--tolerance", "1e-4"}, 2, "nosuch");
  expect_failure(with({"--param", "K"}), 2, "NAME=VALUE");
  expect_failure(with({"--param", "K=x"}), 2, "NAME=VALUE");
  expect_failure(with({"--param", "Q=1"}), 2, "Q");
  expect_failure(with({"--stable"}), 2, "--stable");
  expect_failure(with({"--box", "1,1,0,0"}), 2, "--box");
  expect_failure(with({"-o", "u.doc"}), 2, "u.doc");
  expect_failure(with({"-o", "x.npy", "--json", "x.npy"}), 2, "both write");
}

TEST_F(Grow, SaddlesOfAResonance) {
  const nlohmann::json found = json(
      {"standard", "--param", "K=0.9", "--period", "3", "--turns", "1", "--from=0,1.8", "--stable", "--length", "5"});
  EXPECT_NEAR(found["local_manifold"]["saddle"][1].get<double>(), 1.8024056274013, 1e-12);
  EXPECT_EQ(found["local_manifold"]["steps_of_image"], 3);
  expect_failure({"standard", "--period", "3", "--stable", "--length", "5"}, 1, "that moves by 0 turns");
  expect_failure({"henon", "--turns", "1", "--stable", "--length", "5"}, 2, "does not repeat after a shift");
}

}  // namespace
}  // namespace lober::cli
