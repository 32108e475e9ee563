// The members of the JSON of `lober tangle` and of the tangle graph are a contract, and their bytes depend on input and
// options only.

#include <algorithm>
#include <set>

#include "tests/cli/tangle_program.hpp"

namespace lober::cli {
namespace {

using Names = std::set<std::string>;

class TangleJson : public ProgramTest {};

TEST_F(TangleJson, HasTheMembersOfTheContract) {
  const Json result = tangle({demo, "--overlaps"});
  EXPECT_EQ(members(result), (Names{"program", "command", "inputs", "agreement", "disagreements", "options",
                                    "crossings", "pips", "lobes", "bip", "boundary", "images", "turnstile", "overlaps",
                                    "remarks", "error", "statistics", "timing"}));
  EXPECT_EQ(result["command"], "tangle");
  ASSERT_EQ(result["inputs"].size(), 2U);
  EXPECT_EQ(members(result["inputs"][0]), (Names{"file", "zone", "sha256", "points", "reversed"}));
  EXPECT_EQ(result["crossings"]["count"], 15);
  EXPECT_EQ(result["crossings"]["contacts"], 1);
  EXPECT_EQ(members(result["pips"][0]), (Names{"x", "y", "u", "s", "rho", "crossing"}));
  EXPECT_EQ(members(result["pips"][0]["u"]), (Names{"segment", "t"}));
  for (std::size_t k = 0; k < result["lobes"].size(); ++k) {
    const Json& lobe = result["lobes"][k];
    EXPECT_EQ(members(lobe), (Names{"index", "area", "inside", "outside", "perimeter", "simple", "label", "width",
                                    "centroid", "rounding", "discretisation"}));
    EXPECT_EQ(lobe["index"], k);
    EXPECT_NEAR(lobe["inside"].get<double>() + lobe["outside"].get<double>(), std::abs(lobe["area"].get<double>()),
                lobe["rounding"].get<double>());
  }
  EXPECT_EQ(members(result["bip"]), (Names{"index", "x", "y"}));
  EXPECT_EQ(members(result["boundary"]),
            (Names{"area", "rounding", "discretisation", "points", "orientation", "crosses_itself", "closure"}));
  EXPECT_EQ(members(result["turnstile"]), (Names{"lobes", "lobe_area12", "lobe_area21", "reason"}));
  EXPECT_EQ(members(result["overlaps"][0]), (Names{"i", "j", "area", "error", "perimeter"}));
  EXPECT_EQ(members(result["error"]), (Names{"rounding", "discretisation", "consistency"}));
  for (const char* name : {"index", "boxes_tested", "pairs_tested", "filter_failures", "exact_calls", "skipped"}) {
    EXPECT_TRUE(result["statistics"].contains(name)) << name;
  }
  for (const char* name :
       {"read", "index", "check", "crossings", "order", "pips", "areas", "overlaps", "write", "total"}) {
    EXPECT_TRUE(result["timing"][name].is_number()) << name;
  }
  EXPECT_TRUE(tangle({demo})["overlaps"].is_null());  // not asked for
}

TEST_F(TangleJson, GivesTheBoundaryItsErrorBars) {
  for (const bool smooth : {false, true}) {
    const Json result = smooth ? tangle({demo, "--smooth"}) : tangle({demo});
    for (const char* bar : {"rounding", "discretisation"}) {
      EXPECT_GT(result["boundary"][bar].get<double>(), 0) << bar;
      EXPECT_EQ(result["boundary"][bar], result["error"][bar]["boundary"]) << bar;
    }
  }
}

// The rows of the graph by the names of their columns.
std::vector<Json> rows(const Json& graph) {
  std::vector<Json> result;
  for (const Json& node : graph["nodes"]) {
    Json row;
    EXPECT_EQ(node.size(), graph["columns"].size());
    for (std::size_t k = 0; k < node.size(); ++k) row[graph["columns"][k].get<std::string>()] = node[k];
    result.push_back(row);
  }
  return result;
}

TEST_F(TangleJson, GraphTellsWhichCrossingsAreOnWhichLobe) {
  ASSERT_EQ(run({"tangle", demo, "--graph", "graph"}).status, 0);
  const Json graph = Json::parse(read("graph")), result = tangle({demo});
  const std::vector<Json> nodes = rows(graph);
  ASSERT_EQ(nodes.size(), 16U);
  std::vector<int> by_s(nodes.size(), -1);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_EQ(nodes[k]["order_u"], k);
    by_s.at(nodes[k]["order_s"]) = static_cast<int>(k);
    EXPECT_EQ(nodes[k]["generation"], nodes[k]["arc_u"].get<int>() - nodes[k]["arc_s"].get<int>());
    EXPECT_EQ(nodes[k]["kind"] == "touch", nodes[k]["rho"] == 0);
  }
  EXPECT_EQ(std::count(by_s.begin(), by_s.end(), -1), 0);  // a permutation
  ASSERT_EQ(graph["pips"].size(), result["pips"].size());
  for (std::size_t k = 0; k < graph["pips"].size(); ++k) {
    const Json& node = nodes.at(graph["pips"][k]);
    EXPECT_EQ(node["kind"], "pip");
    EXPECT_EQ(node["x"], result["pips"][k]["x"]);
    EXPECT_EQ(node["rho"], result["pips"][k]["rho"]);
    EXPECT_EQ(node["arc_u"], k);
    EXPECT_EQ(node["arc_s"], k);
  }
  // Each arc of a lobe runs from pip to pip, and the crossings between them lie on that arc.
  ASSERT_EQ(graph["lobes"].size(), 10U);
  std::size_t sips = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    const Json& lobe = graph["lobes"][k];
    const int u0 = lobe["u"][0], u1 = lobe["u"][1], s0 = lobe["s"][0], s1 = lobe["s"][1];
    EXPECT_EQ(graph["pips"][k], u0);
    EXPECT_EQ(graph["pips"][k + 1], u1);
    EXPECT_EQ(nodes[static_cast<std::size_t>(u0)]["order_s"], s1);
    EXPECT_EQ(nodes[static_cast<std::size_t>(u1)]["order_s"], s0);
    for (int m = u0 + 1; m < u1; ++m) {
      EXPECT_EQ(nodes[static_cast<std::size_t>(m)]["arc_u"], k);
      ++sips;
    }
    for (int m = s0 + 1; m < s1; ++m) {
      const auto node = static_cast<std::size_t>(by_s.at(static_cast<std::size_t>(m)));
      EXPECT_EQ(nodes[node]["arc_s"], k);
    }
  }
  EXPECT_EQ(sips, 4U);  // the last lobe cuts the first one
}

TEST_F(TangleJson, IsTheSameForAnyNumberOfThreadsAndAnyIndex) {
  std::vector<Point> u, s;
  for (int k = 0; k <= 60'000; ++k) {
    const double x = k / 6000.0;
    u.push_back({x, std::sin(40 * x) + 0.2 * std::sin(391 * x)});
    s.push_back({10 - x, 0.3 * std::sin(70 * x)});
  }
  write_curve("u", u);
  write_curve("s", s);
  const auto files = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"tangle", "u", "s", "--overlaps", "--json", "json", "--graph", "graph", "--lobes",
                               "lobes", "--svg", "svg"});
    EXPECT_EQ(run(more).status, 0);
    return std::vector<std::string>{without_timing(read("json")), read("graph"), read("lobes"), read("svg")};
  };
  const std::vector<std::string> one = files({"--threads", "1"});
  EXPECT_GT(Json::parse(one[1])["nodes"].size(), 100U);
  for (const char* threads : {"2", "5"}) EXPECT_EQ(files({"--threads", threads}), one) << threads;
  EXPECT_EQ(files({"--threads", "2", "--index", "grid"})[1], one[1]);
}

}  // namespace
}  // namespace lober::cli
