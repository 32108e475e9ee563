// `lober densify` as a user runs it.

#include <algorithm>
#include <cmath>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class Densify : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("square", box(0, 0, 4, 4));
    write_curve("other", box(2, 2, 6, 6));
    write_curve("flower", flower(200, 5, 0.2, {0, 0}));
  }
  Outcome densify(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "densify");
    return run(arguments);
  }
  void succeed(const std::vector<std::string>& arguments) {
    const Outcome outcome = densify(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
  // The rows of a table of text, behind the notes on where it comes from.
  std::string rows(const std::string& name) const {
    std::string text = read(name);
    EXPECT_TRUE(text.starts_with("# lober: ")) << name;
    while (text.starts_with('#')) text.erase(0, text.find('\n') + 1);
    return text;
  }
  std::vector<Point> points(const std::string& name) { return read_curve_file(folder() / name).zones[0].points; }
  void expect_failure(const std::vector<std::string>& arguments, int status, std::string_view words) {
    write("out.csv", "precious\n");
    const Outcome outcome = densify(arguments);
    std::string command = "lober densify";
    for (const std::string& argument : arguments) command += " " + argument;
    EXPECT_EQ(outcome.status, status) << command << '\n' << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << command << '\n' << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("lober: ")) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << command << '\n' << outcome.err;
    EXPECT_EQ(read("out.csv"), "precious\n") << command;
  }
};

TEST_F(Densify, DistanceInEveryFormat) {
  for (const char* name : {"out.npy", "out.csv", "out.txt", "out.dat", "out.raw"}) {
    succeed({"square", "-o", name, "--max-length", "1"});
    const std::vector<Point> dense = points(name);
    ASSERT_EQ(dense.size(), 16U) << name;
    EXPECT_EQ(dense[1], (Point{1, 0})) << name;
    EXPECT_EQ(dense[15], (Point{0, 1})) << name;
  }
  EXPECT_EQ(rows("out.csv").substr(0, 8), "0,0\n1,0\n");
  EXPECT_EQ(densify({"square", "-o", "-", "--max-length", "2"}).out, "0 0\n2 0\n4 0\n4 2\n4 4\n2 4\n0 4\n0 2\n");
}

TEST_F(Densify, OpenCurves) {
  succeed({"square", "-o", "out.csv", "--max-length", "1", "--open"});
  EXPECT_EQ(points("out.csv").size(), 13U);
  EXPECT_EQ(points("out.csv").back(), (Point{0, 4}));
}

TEST_F(Densify, Interpolations) {
  std::vector<std::string> written;
  for (const char* kind : {"linear", "spline", "dritschel"}) {
    succeed({"flower", "-o", "out.csv", "--max-length", "0.01", "--interpolation", kind});
    written.push_back(rows("out.csv"));
    EXPECT_GT(points("out.csv").size(), 600U);
  }
  EXPECT_NE(written[0], written[1]);
  EXPECT_NE(written[1], written[2]);
}

TEST_F(Densify, HobsonTellsWhatItDid) {
  const Outcome outcome = densify({"flower", "-o", "out.csv", "--hobson", "--angle", "0.05", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["command"], "densify");
  EXPECT_EQ(json["options"]["interpolation"], "dritschel");
  EXPECT_EQ(json["options"]["angle"], 0.05);
  EXPECT_EQ(json["options"]["max_length"], nullptr);
  EXPECT_EQ(json["result"]["points"], points("out.csv").size());
  EXPECT_GT(points("out.csv").size(), 200U);
  EXPECT_TRUE(json["diagnostics"]["list"].empty());
  EXPECT_EQ(json["inputs"][0]["points"], 200);
}

TEST_F(Densify, DiagnosticsAreListed) {
  const Outcome outcome =
      densify({"square", "-o", "out.csv", "--max-length", "0.001", "--max-points", "100", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("the curve has 100 points and does not meet the criteria"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("give a larger max_points"), std::string::npos) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["result"]["points"], 100);
  EXPECT_EQ(json["diagnostics"]["counts"]["max_points"], 4);
  EXPECT_EQ(json["diagnostics"]["list"][1]["segment"], 25);
  EXPECT_EQ(json["diagnostics"]["list"][1]["count"], 25);
}

TEST_F(Densify, NearAnotherCurve) {
  succeed({"square", "other", "-o", "out.csv", "--passes", "2", "--points", "9"});
  EXPECT_EQ(points("out.csv").size(), 4U + 2 * 18);
  succeed({"square", "other", "-o", "out.csv", "--crossings", "--against-output", "against.csv"});
  EXPECT_EQ(rows("out.csv"), "0,0\n4,0\n4,2\n4,4\n2,4\n0,4\n");
  EXPECT_EQ(rows("against.csv"), "2,2\n4,2\n6,2\n6,6\n2,6\n2,4\n");
}

TEST_F(Densify, RemovesWhatIsTooMuch) {
  succeed({"square", "-o", "dense.csv", "--max-length", "0.01"});
  succeed({"dense.csv", "-o", "out.csv", "--simplify", "1e-12"});
  EXPECT_EQ(rows("out.csv"), "0,0\n4,0\n4,4\n0,4\n");
  succeed({"dense.csv", "-o", "out.csv", "--simplify", "1e-12", "--max-length", "1", "--json", "out.json"});
  const auto options = nlohmann::json::parse(read("out.json"))["options"];
  EXPECT_EQ(options["simplify"], 1e-12);
  EXPECT_EQ(options["max_length"], 1);
  EXPECT_LT(points("out.csv").size(), 33U);
}

TEST_F(Densify, SameBytesForAnyNumberOfThreads) {
  std::vector<std::string> written;
  for (const char* threads : {"1", "2", "7"}) {
    succeed({"flower", "other", "-o", "out.raw", "--max-length", "1e-4", "--interpolation", "spline", "--passes", "2",
             "--points", "5", "--crossings", "--threads", threads});
    written.push_back(read("out.raw"));
  }
  EXPECT_EQ(written[0], written[1]);
  EXPECT_EQ(written[0], written[2]);
}

TEST_F(Densify, WrongCommandLines) {
  expect_failure({}, 2, "CURVES is missing");
  expect_failure({"square", "-o", "out.csv"}, 2, "no step is given");
  expect_failure({"square", "--max-length", "1"}, 2, "--output is missing");
  expect_failure({"square", "-o", "out.csv", "--max-length", "0"}, 2, "--max-length");
  expect_failure({"square", "-o", "out.csv", "--max-length", "nan"}, 2, "--max-length: nan is not a number above 0");
  expect_failure({"square", "-o", "out.csv", "--simplify", "-1"}, 2, "--simplify: -1 is not a number from 0 on");
  expect_failure({"square", "-o", "out.csv", "--simplify", "inf"}, 2, "--simplify: inf is not a number from 0 on");
  expect_failure({"square", "-o", "out.csv", "--max-length", "1", "--interpolation", "quintic"}, 2, "--interpolation");
  expect_failure({"square", "-o", "out.csv", "--angle", "0.1", "--interpolation", "linear"}, 2, "linear");
  expect_failure({"square", "-o", "out.csv", "--passes", "1", "--points", "2"}, 2, "AGAINST");
  expect_failure({"square", "other", "-o", "out.csv", "--passes", "1"}, 2, "--points");
  expect_failure({"square", "other", "-o", "out.csv", "--max-length", "1"}, 2, "AGAINST");
  expect_failure({"square", "-o", "out.csv", "--min-length", "1"}, 2, "--min-length");
  expect_failure({"square", "-o", "out.xyz", "--max-length", "1"}, 2, "out.xyz");
  expect_failure({"square", "-o", "out.csv", "--max-length", "1", "--json", "out.csv"}, 2, "both write");
  expect_failure({"out.csv", "-o", "out.csv", "--max-length", "1"}, 2, "overwrite");
}

TEST_F(Densify, BadData) {
  expect_failure({"nowhere", "-o", "out.csv", "--max-length", "1"}, 1, "nowhere: ");
  write("nan", "0 0\n1 0\nnan 1\n");
  expect_failure({"nan", "-o", "out.csv", "--max-length", "1"}, 1, "nan:3: ");
  expect_failure({"square", "nan", "-o", "out.csv", "--crossings"}, 1, "nan:3: ");
  write("two", "0 0\n1 0\n1 0\n");
  expect_failure({"two", "-o", "out.csv", "--max-length", "1"}, 1, "two: ");
  succeed({"two", "-o", "fine.csv", "--max-length", "0.5", "--open"});
  EXPECT_EQ(rows("fine.csv"), "0,0\n0.5,0\n1,0\n");
  expect_failure({"square", "-o", "nowhere/out.csv", "--max-length", "1"}, 1, "nowhere/out.csv");
}

}  // namespace
}  // namespace lober::cli
