// `lober transport` and `lober tangle --system` as a user runs them, against reference values (110-digit arithmetic for
// maps, quadruple precision for the vortex pair).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {
namespace {

constexpr double henon_lobe = 1.0364943412491413807970964288427805111;  // k = 0.5
constexpr double vortex_lobe = 0.254106277099506951;                    // gamma = 0.5, eps = 0.1

class TransportCommand : public ProgramTest {
 protected:
  [[nodiscard]] Outcome transport(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "transport");
    return run(arguments);
  }
  [[nodiscard]] nlohmann::json json(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = transport(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
  void expect_failure(const std::vector<std::string>& arguments, int status, std::string_view words) const {
    const Outcome outcome = transport(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
};

TEST_F(TransportCommand, HenonMap) {
  const nlohmann::json found = json({"henon", "--param", "k=0.5", "--iterates", "8", "--tolerance", "1e-6"});
  EXPECT_EQ(found["command"], "transport");
  EXPECT_EQ(found["system"], nlohmann::json({{"name", "henon"}, {"parameters", {{"k", 0.5}}}}));
  EXPECT_NEAR(found["region"]["area"].get<double>(), 9.5886920061239648399055, 1e-8);
  EXPECT_NEAR(found["turnstile"]["lobe_area12_by_action"].get<double>(), henon_lobe, 1e-14);
  EXPECT_NEAR(found["turnstile"]["flux21"].get<double>(), henon_lobe, 1e-9);
  const std::array<double, 8> fluxes{henon_lobe,         henon_lobe,         henon_lobe,         0.9589873456950768,
                                     0.5826983180488817, 0.4718224531769735, 0.4449562082011657, 0.3472857694532555};
  ASSERT_EQ(found["steps"].size(), fluxes.size());
  double total = 0;
  for (std::size_t k = 0; k < fluxes.size(); ++k) {
    const nlohmann::json& step = found["steps"][k];
    total += fluxes[k];
    EXPECT_EQ(step["n"], k + 1);
    EXPECT_NEAR(step["a"].get<double>(), fluxes[k], 1e-10);
    EXPECT_NEAR(step["T"].get<double>(), total, 1e-9);
    EXPECT_NEAR(step["T_by_boundaries"].get<double>(), total, 1e-4);
    EXPECT_LE(std::fabs(step["T_by_boundaries"].get<double>() - total), step["boundary_error"].get<double>());
  }
}

TEST_F(TransportCommand, VortexPairFromItsEquations) {
  const Outcome outcome =
      transport({"ovp", "--param", "gamma=0.5", "--iterates", "3", "--tolerance", "1e-3", "--integration-tolerance",
                 "1e-10", "--json", "t.json", "--svg", "t.svg", "--picture", "p.svg"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("0.2541062771"), std::string::npos) << outcome.out;
  const nlohmann::json found = nlohmann::json::parse(read("t.json"));
  EXPECT_NEAR(found["saddles"]["unstable"]["at"][0].get<double>(), 1.451260038107551142, 1e-9);
  EXPECT_NEAR(found["saddles"]["unstable"]["multiplier"].get<double>(), 5.075684315001539492, 1e-8);
  EXPECT_NEAR(found["turnstile"]["lobe_area21_by_action"].get<double>(), vortex_lobe, 1e-10);
  EXPECT_NEAR(found["steps"][2]["a"].get<double>(), 0.238144168406064, 1e-7);
  EXPECT_NE(read("t.svg").find("T(n)"), std::string::npos);
  EXPECT_NE(read("p.svg").find("L21(1)"), std::string::npos);
}

// Fluid that has left a bounded flow comes back: by the sum of one kind of overlap alone T(2) would be 0.70508.
TEST_F(TransportCommand, FluidThatComesBack) {
  const nlohmann::json found = json({"duffing", "--iterates", "2", "--tolerance", "1e-4", "--particles", "5000"});
  EXPECT_EQ(found["agreement"], true);
  EXPECT_TRUE(found["disagreements"].empty());
  const nlohmann::json& step = found["steps"][1];
  for (const char* name : {"T", "T12", "T21", "T_by_boundaries"})
    EXPECT_NEAR(step[name].get<double>(), 0.63950, 1e-5) << name;
  EXPECT_NEAR(step["T_by_particles"].get<double>(), 0.63950, 5 * step["particle_error"].get<double>());
  EXPECT_NEAR(step["overlaps"]["L21_L12"].get<double>(), 0.06558879338, 1e-6);
  EXPECT_EQ(step["T_ij"].size(), 2U);
}

TEST_F(TransportCommand, RegionsOfBothVortices) {
  const nlohmann::json found =
      json({"ovp", "--all-regions", "--iterates", "1", "--tolerance", "1e-3", "--integration-tolerance", "1e-10"});
  ASSERT_EQ(found["regions"].size(), 3U);
  EXPECT_EQ(found["regions"][1]["bounded"], false);
  EXPECT_NEAR(found["steps"][0]["T_ij"][2][1].get<double>(), vortex_lobe, 1e-5);
  EXPECT_NEAR(found["steps"][0]["T_ij"][0][2].get<double>(), 0, 1e-9);
}

// Routes that disagree are reported on the first line, in the JSON and by the exit status.
TEST_F(TransportCommand, DisagreementIsLoud) {
  const Outcome outcome =
      transport({LOBER_TEST_LIBRARIES "/leaky.so", "--iterates", "2", "--tolerance", "1e-4", "--json", "t.json"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("DISAGREEMENT: ")) << outcome.out;
  EXPECT_NE(outcome.out.find("T12(n)"), std::string::npos);
  const nlohmann::json found = nlohmann::json::parse(read("t.json"));
  EXPECT_EQ(found["agreement"], false);
  ASSERT_FALSE(found["disagreements"].empty());
  EXPECT_NE(found["disagreements"][0]["first"]["value"], found["disagreements"][0]["second"]["value"]);
}

TEST_F(TransportCommand, FromManifoldFiles) {
  for (const auto& [side, file] : {std::pair{"--unstable", "u.npy"}, {"--stable", "s.npy"}}) {
    const Outcome grown =
        run({"grow", "henon", "--param", "k=0.5", side, "--tolerance", "1e-6", "--iterates", "5", "-o", file});
    ASSERT_EQ(grown.status, 0) << grown.err;
  }
  const nlohmann::json found = json(
      {"--manifolds", "u.npy", "s.npy", "--bip=-1.533,0.925", "--period", "2", "--iterates", "4", "--no-check-simple"});
  ASSERT_GE(found["steps"].size(), 4U);
  EXPECT_NEAR(found["steps"][3]["T"].get<double>(), 4.068470369442501, 1e-6);
  EXPECT_NEAR(found["steps"][3]["T_by_boundaries"].get<double>(), 4.068470369442501, 1e-4);
}

// Manifolds that run inward are the same ones in reverse order, named as for `lober tangle`.
TEST_F(TransportCommand, FromManifoldFilesThatRunInward) {
  std::vector<Curve> manifolds;
  for (const char* zone : {"#0", "#1"}) {
    manifolds.push_back(read_curve(std::string(LOBER_SOURCE_DIR "/examples/manifolds.dat") + zone, false).curve);
    write_curve(zone[1] == '0' ? "u" : "s", manifolds.back().points);
    std::reverse(manifolds.back().points.begin(), manifolds.back().points.end());
    write_curve(zone[1] == '0' ? "u-inward" : "s-inward", manifolds.back().points);
  }
  const auto steps = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"--manifolds"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return json(all)["steps"];
  };
  const nlohmann::json outward = steps({"u", "s"});
  ASSERT_FALSE(outward.empty());
  EXPECT_EQ(steps({"u-inward", "s", "--reverse", "u"}), outward);
  EXPECT_EQ(steps({"u", "s-inward", "--reverse", "s"}), outward);
  EXPECT_EQ(steps({"u-inward", "s-inward", "--reverse", "both"}), outward);
  expect_failure({"--manifolds", "u", "s", "--reverse", "inward"}, 2, "--reverse");
}

TEST_F(TransportCommand, FromManifoldFilesSaysWhereItEnds) {
  const std::string curves = LOBER_SOURCE_DIR "/examples/manifolds.dat";
  const Outcome outcome = transport({"--manifolds", curves, "--iterates", "20"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nn = 1 to 4 of 20: the curves show the images of the bip q from f^-2(q) to f^2(q)"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(json({"--manifolds", curves, "--iterates", "20"})["stop"]["reason"], "curves");
  EXPECT_TRUE(json({"--manifolds", curves, "--iterates", "4"})["stop"].is_null());
  expect_failure({"--manifolds", curves, "--period", "3"}, 2, "the period 3 does not fit");
}

TEST_F(TransportCommand, SaysThatThereIsNoZero) {
  const nlohmann::json found = json({"standard", "--sweep", "K=1:1.2:0.1", "--find-zero", "--tolerance", "1e-4"});
  EXPECT_EQ(found["zeros"].size(), 0U);
  const std::string why = found["no_zero"];
  for (const char* words : {"does not change sign", "K = 1, where it is 0.02536", "K = 1.2, where it is 0.05805"}) {
    EXPECT_NE(why.find(words), std::string::npos) << why;
  }
  const Outcome outcome = transport({"standard", "--sweep", "K=1:1.2:0.1", "--find-zero", "--tolerance", "1e-4"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find(why), std::string::npos) << outcome.out;
  EXPECT_TRUE(json({"standard", "--sweep", "K=1:1.2:0.1", "--tolerance", "1e-4"})["no_zero"].is_null());
}

// A lifted angle: the system's tangle ends a period farther, and its directions belong to that.
TEST_F(TransportCommand, FromASaddleOfALiftedAngle) {
  const nlohmann::json own = json({"standard", "--iterates", "2", "--tolerance", "1e-4"});
  const nlohmann::json given = json({"standard", "--iterates", "2", "--tolerance", "1e-4", "--from", "0,0"});
  EXPECT_EQ(given["saddles"]["stable"]["at"], own["saddles"]["stable"]["at"]);
}

TEST_F(TransportCommand, NegativeKicksAreHalfAPeriodFarther) {
  const nlohmann::json plus = json({"standard", "--iterates", "2", "--tolerance", "1e-4"});
  const nlohmann::json minus = json({"standard", "--param", "K=-1.2", "--iterates", "2", "--tolerance", "1e-4"});
  EXPECT_NEAR(minus["turnstile"]["flux12"].get<double>(), plus["turnstile"]["flux12"].get<double>(), 1e-6);
}

// One word in the row of a value that failed, and each reason once below the table.
TEST_F(TransportCommand, SweepSaysWhyValuesFailedBelowTheTable) {
  const Outcome outcome = transport({"henon", "--sweep", "k=-3:0.5:1.25", "--tolerance", "1e-4"});
  EXPECT_EQ(outcome.status, 1);
  std::istringstream lines(outcome.out);
  std::vector<std::string> failed, reasons;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(" failed")) failed.push_back(line);
    if (line.starts_with("failed at k = ")) reasons.push_back(line);
    EXPECT_TRUE(line.starts_with("failed at") || line.size() < 170) << line;
  }
  EXPECT_EQ(failed, (std::vector<std::string>{"        -3 failed", "     -1.75 failed"})) << outcome.out;
  ASSERT_EQ(reasons.size(), 1U) << outcome.out;
  EXPECT_TRUE(reasons[0].starts_with("failed at k = -3 and 1 more: system henon has no tangle")) << reasons[0];
  EXPECT_LT(outcome.out.find("      -0.5 "), outcome.out.find(reasons[0]));
}

TEST_F(TransportCommand, SweepKeepsWhatWorks) {
  const Outcome outcome =
      transport({"henon", "--sweep", "k=-2:0.5:1.25", "--tolerance", "1e-4", "--json", "s.json", "--svg", "s.svg"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("1 of 3 values failed, the first at k = -2"), std::string::npos) << outcome.err;
  const nlohmann::json found = nlohmann::json::parse(read("s.json"));
  ASSERT_EQ(found["rows"].size(), 3U);
  EXPECT_EQ(found["failures"], 1);
  EXPECT_TRUE(found["rows"][0]["failure"].is_string());
  EXPECT_EQ(found["rows"][1]["value"], -0.75);
  EXPECT_TRUE(found["rows"][2]["failure"].is_null());
  EXPECT_EQ(found["rows"][2]["period"], 2);
  EXPECT_NEAR(found["rows"][2]["lobe_area21_by_action"].get<double>(), henon_lobe, 1e-14);
  EXPECT_NEAR(found["rows"][2]["flux12"].get<double>(), henon_lobe, 1e-5);
}

// sqrt(2) pi omega sech(pi omega / 2) sin(omega t0) has lobes of twice its amplitude / omega.
TEST_F(TransportCommand, MelnikovsFunctionOfTheDuffingOscillator) {
  const nlohmann::json found =
      json({"duffing", "--param", "eps=0.01", "--iterates", "1", "--melnikov", "--tolerance", "1e-4"})["melnikov"];
  using std::numbers::pi;
  const double amplitude = std::sqrt(2) * pi / std::cosh(0.5 * pi);
  EXPECT_EQ(found["parameter"], "eps");
  EXPECT_EQ(found["eps"], 0.01);
  EXPECT_EQ(found["zeros"].size(), 2U);
  EXPECT_EQ(found["lobes"].size(), 2U);
  EXPECT_NEAR(found["largest"].get<double>(), amplitude, 1e-8);
  for (const char* side : {"left", "right"}) {
    EXPECT_NEAR(found["first_order"][side].get<double>(), 0.01 * 2 * amplitude, 1e-10);
    EXPECT_NEAR(found["exact"][side].get<double>(), 0.01 * 2 * amplitude, 1e-5);
  }
  const Outcome table = transport({"duffing", "--iterates", "1", "--melnikov", "--tolerance", "1e-4"});
  EXPECT_NE(table.out.find("lobes on the left of U: first order 0.354130"), std::string::npos) << table.out;
}

TEST_F(TransportCommand, AValueOfTheParameterThatIsSweptIsRemarkedOn) {
  const Outcome one =
      transport({"henon", "--param", "k=0.7", "--sweep", "k=1.02:1.12:0.1", "--tolerance", "1e-3", "--json", "-"});
  EXPECT_EQ(one.status, 0) << one.err;
  const std::string remark = "k = 0.7 was given, but is not used: the values are those of the range k=1.02:1.12:0.1";
  EXPECT_NE(one.err.find(remark), std::string::npos) << one.err;
  EXPECT_NE(one.out.find(remark), std::string::npos) << one.out;
}

TEST_F(TransportCommand, AStepLongerThanTheRangeIsRemarkedOn) {
  const Outcome one = transport({"henon", "--sweep", "k=1.02:1.5:200", "--tolerance", "1e-3"});
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_NE(one.err.find("the step of k=1.02:1.5:200 is longer than its range, so there is one value"),
            std::string::npos)
      << one.err;
  EXPECT_EQ(transport({"henon", "--sweep", "k=1.02:1.02:1", "--tolerance", "1e-3"}).err, "");
}

// By the second derivative of the area the estimate is off by eps^2 at most: along a sweep of eps it is a line.
TEST_F(TransportCommand, SweepComparesWithMelnikovsFunction) {
  const nlohmann::json rows =
      json({"ovp", "--sweep", "eps=0.004:0.008:0.004", "--melnikov", "--tolerance", "1e-4", "--svg", "s.svg"})["rows"];
  ASSERT_EQ(rows.size(), 2U);
  const auto number = [&](std::size_t row, const char* name) { return rows[row][name].get<double>(); };
  EXPECT_NEAR(number(1, "first_order"), 2 * number(0, "first_order"), 1e-15);
  const double fine = number(0, "lobe_area21_by_action") - number(0, "first_order");
  const double coarse = number(1, "lobe_area21_by_action") - number(1, "first_order");
  EXPECT_GT(coarse / fine, 3.5);
  EXPECT_NE(read("s.svg").find("first order in eps (Melnikov)"), std::string::npos);
  expect_failure({"standard", "--melnikov"}, 2, "the size of a perturbation, such as eps of ovp");
  expect_failure({"standard", "--melnikov", "--sweep", "K=1:2:1"}, 2, "the size of a perturbation, such as eps of ovp");
}

TEST_F(TransportCommand, SignChangeOfTheVortexPair) {
  const nlohmann::json found = json({"ovp1", "--sweep", "gamma=1.4:1.41:0.01", "--find-zero", "--tolerance", "1e-3",
                                     "--integration-tolerance", "1e-9"});
  ASSERT_EQ(found["zeros"].size(), 1U);
  EXPECT_NEAR(found["zeros"][0]["value"].get<double>(), 1.407, 1e-3);
  EXPECT_TRUE(found["zeros"][0]["failure"].is_null());
}

TEST_F(TransportCommand, SameBytesForAnyNumberOfThreads) {
  std::array<std::string, 2> fluxes, sweeps;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string threads = k == 0 ? "1" : "7";
    EXPECT_EQ(
        transport({"standard", "--iterates", "4", "--json", "t", "--picture", "p" + threads, "--threads", threads})
            .status,
        0);
    fluxes[k] = without_timing(read("t"));
    EXPECT_EQ(transport({"standard", "--sweep", "K=1.5:2.5:0.25", "--json", "s", "--threads", threads}).status, 0);
    sweeps[k] = without_timing(read("s"));
  }
  EXPECT_EQ(fluxes[0], fluxes[1]);
  EXPECT_EQ(sweeps[0], sweeps[1]);
  EXPECT_EQ(read("p1"), read("p7"));
}

TEST_F(TransportCommand, Refuses) {
  expect_failure({"nosuch"}, 2, "there are: abc, capsize");
  expect_failure({"ovp", "--param", "gama=0.5"}, 2, "it has: gamma, eps, phase");
  expect_failure({"ovp", "--param", "gamma"}, 2, "NAME=VALUE");
  expect_failure({"ovp", "--param", "gamma=-1"}, 2, "gamma must be positive");
  expect_failure({"ovp", "--sweep", "gama=1:2:1"}, 2, "it has: gamma, eps, phase");
  expect_failure({"ovp", "--sweep", "gamma=1:2"}, 2, "FIRST:LAST:STEP");
  expect_failure({"ovp", "--sweep", "gamma=1:2:-1"}, 2, "leads from the first value");
  expect_failure({"ovp", "--find-zero"}, 2, "--sweep");
  expect_failure({"capsize"}, 2, "give --from");
  expect_failure({"standard", "--from", "3.14159,0"}, 1, "is not a saddle, but of the kind centre");
  expect_failure({"standard", "--param", "K=0"}, 2, "every circle p = const is invariant");
  expect_failure({"henon", "--param", "k=-2"}, 2, "no fixed points for k < -1");
  expect_failure({"henon", "--bip", "100,100"}, 1, "no pip was found near the bip asked for, (100, 100)");
  expect_failure({"standard", "--svg", "x", "--picture", "x"}, 2, "both write");
  expect_failure({"standard", "--iterates", "4", "--max-points", "100"}, 1,
                 "the limit on points (--max-points) allows 100");
}

TEST_F(TransportCommand, TangleOfASystem) {
  const Outcome outcome =
      run({"tangle",     "--system",   "henon",  "--param", "k=0.5",   "--tolerance", "1e-6",    "--after",
           "1",          "--overlaps", "--json", "t.json",  "--graph", "g.json",      "--lobes", "l.dat",
           "--boundary", "b.dat",      "--pips", "p.dat",   "--svg",   "t.svg"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("area by action"), std::string::npos);
  const nlohmann::json found = nlohmann::json::parse(read("t.json"));
  const nlohmann::json& lobes = found["turnstile_by_action"]["lobes"];
  ASSERT_EQ(lobes.size(), 2U);
  for (const nlohmann::json& lobe : lobes) {
    EXPECT_NEAR(std::fabs(lobe["action"].get<double>()), henon_lobe, 1e-14);
    EXPECT_NEAR(std::fabs(lobe["area"].get<double>()), henon_lobe, 1e-9);
    EXPECT_EQ(lobe["area"], found["lobes"][lobe["index"].get<std::size_t>()]["area"]);
  }
  for (const char* file : {"g.json", "l.dat", "b.dat", "p.dat", "t.svg"}) EXPECT_TRUE(exists(file)) << file;
}

TEST_F(TransportCommand, DrawsMultiplesOfTheFirstFlux) {
  const Outcome outcome =
      run({"transport", "henon", "--param", "k=0.5", "--iterates", "2", "--fluxes", "f.svg", "--normalise"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(read("f.svg").find("area / a(1)"), std::string::npos);
  EXPECT_EQ(run({"transport", "henon", "--normalise"}).status, 2);  // needs --fluxes
}

// The regions of both vortices, with the turnstiles of both boundaries.
TEST_F(TransportCommand, DrawsAllRegions) {
  const Outcome outcome = run({"transport", "ovp", "--all-regions", "--iterates", "1", "--tolerance", "1e-3",
                               "--picture", "r.svg", "--data", "r.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string svg = read("r.svg"), data = read("r.csv");
  for (const char* name : {"L12(1), leaves", "L21(1), enters", "L32(1), leaves", "L23(1), enters"}) {
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  }
  std::size_t bips = 0;
  for (std::size_t at = data.find("\nbip,"); at != std::string::npos; at = data.find("\nbip,", at + 1)) ++bips;
  EXPECT_EQ(bips, 2U);
}

}  // namespace
}  // namespace lober::cli
