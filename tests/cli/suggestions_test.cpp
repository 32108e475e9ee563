// "did you mean": commands, options, values, systems, parameters, operations and keys that are misspelt.

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class Suggestions : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("a", box(0, 0, 1, 1));
    write_curve("b", box(0.5, 0.5, 2, 2));
  }
  void expect_suggestion(const std::vector<std::string>& arguments, const std::string& meant) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << meant;
    EXPECT_EQ(outcome.out, "") << meant;
    EXPECT_NE(outcome.err.find("; did you mean " + meant + "?"), std::string::npos) << outcome.err;
  }
};

TEST_F(Suggestions, OfCommands) {
  expect_suggestion({"overley", "a", "b"}, "overlay");
  expect_suggestion({"trans", "henon"}, "transport");
  expect_suggestion({"docter"}, "doctor");
  expect_suggestion({"fixed_points", "henon"}, "fixed-points");
  expect_suggestion({"help", "tanlge"}, "tangle");
  expect_suggestion({"batch", "rnu", "job.toml"}, "run");
  expect_suggestion({"batch", "opertions"}, "operations");
  expect_suggestion({"--generate", "complete-bsh"}, "complete-bash");
  expect_suggestion({"--generate", "man", "overly"}, "overlay");
  expect_suggestion({"--vresion"}, "--version");
}

TEST_F(Suggestions, OfOptions) {
  expect_suggestion({"overlay", "a", "b", "--lobse", "f"}, "--lobes");
  expect_suggestion({"overlay", "a", "b", "--areas_only"}, "--areas-only");
  expect_suggestion({"grow", "henon", "--stable", "--max_points=3"}, "--max-points");
  expect_suggestion({"overlay", "--josn", "x", "a", "b"}, "--json");
  expect_suggestion({"grow", "henon", "--unstabel"}, "--unstable");
  expect_suggestion({"regions", "a", "--thread", "1"}, "--threads");
  expect_suggestion({"batch", "run", "--shrad", "1/2"}, "--shard");
  expect_suggestion({"doctor", "-json"}, "--json");
  EXPECT_EQ(run({"overlay", "a", "b", "--frobnicate"}).err.find("did you mean"), std::string::npos);
}

TEST_F(Suggestions, OfValues) {
  expect_suggestion({"overlay", "a", "b", "--rule", "nonzer"}, "nonzero");
  expect_suggestion({"overlay", "a", "b", "--index", "gird"}, "grid");
  expect_suggestion({"interior", "a", "b", "--method", "Ends"}, "ends");
  expect_suggestion({"regions", "a", "--rule", "even-odd"}, "evenodd");
  expect_suggestion({"batch", "export", "x", "--format", "jsnol"}, "jsonl");
  expect_suggestion({"schema", "overlya"}, "overlay");
  expect_suggestion({"batch", "operations", "transprot"}, "transport");
}

TEST_F(Suggestions, OfSystemsAndParameters) {
  expect_suggestion({"grow", "henonn", "--unstable", "--iterates", "3"}, "henon");
  expect_suggestion({"systems", "Standard"}, "standard");
  expect_suggestion({"tangle", "pendlum"}, "pendulum");
  expect_suggestion({"transport", "ovp", "--param", "gama=1"}, "gamma");
  expect_suggestion({"transport", "standard", "--param", "k=1"}, "K");
  expect_suggestion({"transport", "ovp", "--sweep", "gama=1:2:1"}, "gamma");
}

TEST_F(Suggestions, OfKeysOfManifests) {
  const auto expect_in_manifest = [&](const std::string& manifest, const std::string& meant) {
    write("job.toml", manifest);
    expect_suggestion({"batch", "check", "job.toml"}, meant);
  };
  expect_in_manifest("opertion = \"overlay\"\ncurves = \"*\"\n", "operation");
  expect_in_manifest("operation = \"overly\"\ncurves = \"*\"\n", "overlay");
  expect_in_manifest("operation = \"overlay\"\ncurve = [\"a\", \"b\"]\n", "curves");
  expect_in_manifest("operation = \"overlay\"\ncurves = [\"a\", \"b\"]\noptions.verfy = true\n", "verify");
  expect_in_manifest("operation = \"overlay\"\ncurves = [\"a\", \"b\"]\noptions.index = \"tre\"\n", "tree");
  expect_in_manifest("[[grop]]\noperation = \"overlay\"\n", "group");
}

}  // namespace
}  // namespace lober::cli
