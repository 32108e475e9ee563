// The members of the JSON of `lober overlay` are a contract, and its bytes depend on input and options only.

#include <set>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"
#include "tests/views.hpp"

namespace lober::cli {
using namespace lober::detail;
namespace {

class OverlayJson : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("c1", flower(30000, 31, 0.1, {0, 0}));
    write_curve("c2", flower(20000, 17, 0.2, {0.05, 0.02}));
  }
};

const std::set<std::string> area_names{"c1",          "c2",          "intersection",        "union",
                                       "c1_minus_c2", "c2_minus_c1", "symmetric_difference"};
const std::set<std::string> pairing_names{"c1_minus_c2", "c2_minus_c1", "intersection", "union"};

TEST_F(OverlayJson, HasTheMembersOfTheContract) {
  const Json result = overlay({"c1", "c2"});
  EXPECT_EQ(members(result), (std::set<std::string>{"program", "command", "inputs", "options", "crossings", "areas",
                                                    "pieces", "slivers", "error", "statistics", "timing", "agreement",
                                                    "disagreements", "piece_counts", "orientation1", "orientation2"}));
  EXPECT_EQ(members(result["program"]), (std::set<std::string>{"name", "version"}));
  EXPECT_EQ(result["command"], "overlay");
  ASSERT_EQ(result["inputs"].size(), 2U);
  EXPECT_EQ(members(result["inputs"][0]),
            (std::set<std::string>{"file", "zone", "sha256", "points", "area", "orientation"}));
  const std::string bytes = read("c1");
  EXPECT_EQ(result["inputs"][0]["sha256"], sha256(std::as_bytes(std::span(bytes))));
  EXPECT_EQ(result["inputs"][0]["file"], "c1");
  EXPECT_EQ(result["inputs"][0]["points"], 30000);
  EXPECT_EQ(members(result["areas"]), area_names);
  EXPECT_EQ(members(result["error"]["rounding"]), area_names);
  EXPECT_EQ(members(result["error"]["discretisation"]), area_names);
  EXPECT_EQ(members(result["pieces"]), pairing_names);
  EXPECT_EQ(members(result["slivers"]), pairing_names);
  for (const char* name : {"read", "index", "crossings", "order", "areas", "write", "total"}) {
    EXPECT_TRUE(result["timing"][name].is_number()) << name;
  }
  for (const char* name : {"index", "boxes_tested", "pairs_tested", "filter_failures", "exact_calls", "skipped"}) {
    EXPECT_TRUE(result["statistics"].contains(name)) << name;
  }
}

TEST_F(OverlayJson, CountsWhatItLists) {
  const Json result = overlay({"c1", "c2"});
  const Json& crossings = result["crossings"];
  EXPECT_GT(crossings["count"], 20);
  EXPECT_EQ(crossings["list"].size(), crossings["count"]);
  EXPECT_EQ(crossings["contacts"], 0);
  EXPECT_EQ(crossings["shared_arcs"], 0);
  int rho = crossings["list"].back()["rho"];
  for (std::size_t k = 0; k < crossings["list"].size(); ++k) {
    const Json& node = crossings["list"][k];
    EXPECT_EQ(node["index"], k);
    EXPECT_EQ(node["rho"], -rho) << "signs alternate along C1";
    rho = node["rho"];
    for (const char* name : {"x", "y", "t1", "t2"}) EXPECT_TRUE(node[name].is_number_float());
    for (const char* name : {"segment1", "segment2", "class", "order2"}) EXPECT_TRUE(node[name].is_number_unsigned());
  }
  for (const std::string& pairing : pairing_names) {
    double sum = 0;
    for (const Json& piece : result["pieces"][pairing]) {
      EXPECT_EQ(members(piece), (std::set<std::string>{"area", "centroid", "crossings", "holes", "sliver"}));
      EXPECT_EQ(piece["centroid"].size(), 2U);
      sum += piece["area"].get<double>();
    }
    EXPECT_NEAR(sum, result["areas"][pairing], 1e-13) << pairing;
  }
  EXPECT_EQ(result["pieces"]["c1_minus_c2"].size(), crossings["classes"]);
}

TEST_F(OverlayJson, TellsTouchesAndSharedArcsApart) {
  write_curve("square", box(0, 0, 4, 4));
  write_curve("touching", std::vector<Point>{{4, 1}, {5, 0}, {5, 2}});
  const Json touch = overlay({"square", "touching"})["crossings"];
  EXPECT_EQ(touch["count"], 0);
  EXPECT_EQ(touch["contacts"], 1);
  EXPECT_EQ(touch["list"][0]["kind"], "touch");
  EXPECT_EQ(touch["list"][0]["rho"], 0);
  EXPECT_TRUE(touch["list"][0]["class"].is_null());
  write_curve("neighbour", box(4, 1, 6, 3));
  const Json arc = overlay({"square", "neighbour"})["crossings"];
  EXPECT_EQ(arc["shared_arcs"], 1);
  EXPECT_EQ(arc["contacts"], 0);
  EXPECT_EQ(arc["list"][0]["kind"], "shared_arc");
  EXPECT_EQ(arc["list"][0]["y"], 1.0);
  EXPECT_EQ(arc["list"][0]["end"]["y"], 3.0);
  EXPECT_EQ(arc["list"][0]["shared"], -1);
  const Json itself = overlay({"square", "square"})["crossings"];
  EXPECT_EQ(itself["shared_arcs"], 1);
  EXPECT_EQ(itself["same_curve"], true);
}

TEST_F(OverlayJson, TellsHoles) {
  write_curve("outer", box(0, 0, 10, 10));
  write_curve("inner", box(2, 2, 4, 4));
  const Json pieces = overlay({"outer", "inner"})["pieces"];
  ASSERT_EQ(pieces["c1_minus_c2"].size(), 1U);
  EXPECT_EQ(pieces["c1_minus_c2"][0]["holes"], 1);
  EXPECT_EQ(pieces["c1_minus_c2"][0]["area"], 96.0);
  EXPECT_NEAR(pieces["c1_minus_c2"][0]["centroid"][0], (500.0 - 12) / 96, 1e-14);
  EXPECT_EQ(pieces["c2_minus_c1"].size(), 0U);
}

TEST_F(OverlayJson, CountsSliversApart) {
  std::vector<Point> curve = flower(3000, 3, 0.2, {0.3, 0.4});
  write_curve("exact", curve);
  for (std::size_t k = 0; k < curve.size() / 2; ++k) {
    curve[k].x = std::nextafter(curve[k].x, k % 3 == 0 ? 10 : -10);
    curve[k].y = std::nextafter(curve[k].y, k % 5 < 2 ? 10 : -10);
  }
  for (std::size_t k = curve.size() / 2 + 1; k < curve.size(); ++k) curve[k].y -= 0.1;
  write_curve("noisy", curve);
  const Json result = overlay({"exact", "noisy"});
  for (const char* pairing : {"c1_minus_c2", "c2_minus_c1"}) {
    std::size_t slivers = 0;
    double area = 0;
    for (const Json& piece : result["pieces"][pairing]) {
      if (!piece["sliver"]) continue;
      ++slivers;
      area += piece["area"].get<double>();
    }
    EXPECT_EQ(result["slivers"][pairing]["count"], slivers);
    EXPECT_EQ(result["slivers"][pairing]["area"], area);
    EXPECT_GT(slivers, 50U);
    EXPECT_LE(result["pieces"][pairing].size() - slivers, 3U);
  }
}

TEST_F(OverlayJson, LeavesOutPiecesWhenTotalsAreAskedFor) {
  const Json all = overlay({"c1", "c2"}), totals = overlay({"c1", "c2", "--areas-only"});
  EXPECT_FALSE(totals.contains("pieces"));
  EXPECT_FALSE(totals.contains("slivers"));
  EXPECT_EQ(totals["areas"], all["areas"]);
  EXPECT_EQ(totals["error"], all["error"]);
  EXPECT_EQ(totals["options"]["areas_only"], true);
}

TEST_F(OverlayJson, VerifiesByTheInteriorMethodWhenAsked) {
  const Json plain = overlay({"c1", "c2"}), verified = overlay({"c1", "c2", "--verify"});
  EXPECT_FALSE(plain["error"].contains("consistency"));
  EXPECT_FALSE(plain["timing"].contains("verify"));
  EXPECT_EQ(plain["areas"], verified["areas"]);
  EXPECT_TRUE(verified["timing"].contains("verify"));
  const Json& consistency = verified["error"]["consistency"];
  EXPECT_EQ(members(consistency), area_names);
  for (const std::string& area : area_names) {
    EXPECT_GE(consistency[area], 0.0);
    EXPECT_LE(consistency[area], 1e-15 * verified["areas"][area].get<double>()) << area;
  }
  EXPECT_NE(run({"overlay", "c1", "c2", "--verify"}).out.find("consistency"), std::string::npos);
  EXPECT_EQ(run({"overlay", "c1", "c2"}).out.find("consistency"), std::string::npos);
}

TEST_F(OverlayJson, HasTheSameBytesForAnyNumberOfThreads) {
  for (const char* index : {"auto", "tree", "grid", "kd"}) {
    std::set<std::string> seen;
    for (const char* threads : {"1", "2", "7"}) {
      const Outcome outcome = run({"overlay", "c1", "c2", "--index", index, "--threads", threads, "--json", "-"});
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      seen.insert(without_timing(outcome.out));
    }
    EXPECT_EQ(seen.size(), 1U) << index;
  }
}

TEST_F(OverlayJson, HasTheSameResultsForEveryIndex) {
  Json reference = overlay({"c1", "c2", "--index", "tree"});
  for (const char* index : {"auto", "grid", "kd"}) {
    const Json result = overlay({"c1", "c2", "--index", index});
    EXPECT_EQ(result["options"]["index"], index);
    for (const char* member : {"inputs", "crossings", "areas", "pieces", "slivers", "error"}) {
      EXPECT_EQ(result[member].dump(), reference[member].dump()) << index << ' ' << member;
    }
  }
}

TEST_F(OverlayJson, IsTheSameInAFileAndOnStandardOutput) {
  const Outcome printed = run({"overlay", "c1", "c2", "--json", "-"});
  const Outcome table = run({"overlay", "c1", "c2", "--json", "result.json"});
  EXPECT_TRUE(Json::accept(printed.out));
  EXPECT_EQ(without_timing(printed.out), without_timing(read("result.json")));
  EXPECT_TRUE(table.out.starts_with("C1"));
}

}  // namespace
}  // namespace lober::cli
