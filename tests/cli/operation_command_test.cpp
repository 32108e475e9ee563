// Operations of the table that have no command of their own, and that every operation can be run from the command line.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lober/operations.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class OperationCommand : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("eight", std::vector<Point>{{-2, -1}, {2, 1}, {2, -1}, {-2, 1}});
    write_curve("box", box(1, -2, 3, 2));
  }
};

std::string as_command(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

TEST_F(OperationCommand, EveryOperationHasOne) {
  const std::string usage = run({"--help"}).out;
  for (const operations::Operation& operation : operations::all()) {
    SCOPED_TRACE(operation.name);
    const Outcome help = run({as_command(operation.name), "--help"});
    EXPECT_EQ(help.status, 0) << help.err;
    EXPECT_NE(help.out.find("Usage: lober " + as_command(operation.name)), std::string::npos) << help.out;
    EXPECT_NE(usage.find("  lober " + as_command(operation.name) + " "), std::string::npos);
  }
}

TEST_F(OperationCommand, OptionsAreThoseOfTheTable) {
  for (const char* const name : {"regions", "curve_transport", "manifold_tangle", "sweep", "simplify"}) {
    const std::string help = run({as_command(name), "--help"}).out;
    for (const operations::OptionSpec& option : operations::named(name).options) {
      EXPECT_NE(help.find(as_command(option.key)), std::string::npos) << name << ": " << option.key;
    }
  }
}

TEST_F(OperationCommand, NumbersAreThoseOfTheOperation) {
  const Json whole = Json::parse(run({"regions", "eight", "box", "--json", "-"}).out);
  const Json by_rule = overlay({"eight", "box", "--rule", "nonzero"});
  for (const char* const member : {"areas", "winding", "pieces", "arrangement", "q1", "q2", "q3", "error"}) {
    EXPECT_EQ(whole[member], by_rule[member]) << member;
  }
  EXPECT_EQ(whole["command"], "regions");
  EXPECT_EQ(whole["inputs"], (Json{"eight", "box"}));
  const Outcome text = run({"regions", "eight", "box"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("areas.c2                                                8  area"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("\nwinding\n  c1  c2  area\n"), std::string::npos) << text.out;
  EXPECT_EQ(run({"regions", "eight"}).status, 0);  // the second curve is optional
}

TEST_F(OperationCommand, TakesSystems) {
  const Outcome found = run({"sweep", "henon", "--range", "k=1:1.2:0.1", "--tolerance", "1e-3"});
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("\nrows\n"), std::string::npos) << found.out;
  const Json json =
      Json::parse(run({"manifold-tangle", "standard", "--param", "K=1.5", "--tolerance", "1e-4", "--json", "-"}).out);
  EXPECT_EQ(json["system"]["name"], "standard");
  EXPECT_EQ(json["system"]["parameters"]["K"], 1.5);
  EXPECT_EQ(json["agreement"], true);
  EXPECT_GT(json["turnstile"]["lobe_area12"].get<double>(), 0);
}

TEST_F(OperationCommand, TakesCurvesAsClosedOrOpen) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}};
  write_curve("square", square);
  const Json closed = Json::parse(run({"simplify", "square", "--tolerance", "0.1", "--json", "-"}).out);
  EXPECT_EQ(closed["result"]["closed"], true);
  EXPECT_EQ(closed["result"]["points"], 4);
  const Json open = Json::parse(run({"simplify", "square", "--tolerance", "0.1", "--no-closed", "--json", "-"}).out);
  EXPECT_EQ(open["result"]["closed"], false);
  EXPECT_EQ(open["result"]["points"], 5);
}

TEST_F(OperationCommand, PolygonsOfManifoldsAreOffByTheirTolerance) {
  const Outcome found = run({"manifold-tangle", "henon", "--no-smooth", "--json", "-"});
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(run({"manifold-tangle", "--help"}).out.find("Do not take the areas of smooth curves"), std::string::npos);
}

TEST_F(OperationCommand, WritesTheCurveThatComesOut) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
  write_curve("square", square);
  const Outcome found = run({"simplify", "square", "--tolerance", "0.1", "-o", "less.csv"});
  EXPECT_EQ(found.status, 0) << found.err;
  const std::string less = read("less.csv");
  EXPECT_TRUE(less.starts_with("# lober: ")) << less;
  EXPECT_TRUE(less.ends_with(" closed=true\n0,0\n2,0\n2,2\n0,2\n")) << less;
  EXPECT_EQ(run({"simplify", "square", "--tolerance", "0.1", "-o", "square"}).status, 2);  // the input
  EXPECT_EQ(run({"simplify", "square", "--tolerance", "0.1", "-o", "less.xyz"}).status, 2);
  EXPECT_EQ(run({"regions", "square", "-o", "x.csv"}).status, 2);  // there is no such curve
}

// In formats that tell polygons from lines.
TEST_F(OperationCommand, ClosedCurvesAreWrittenAsPolygons) {
  write_curve("square", box(0, 0, 1, 1));
  for (const bool closed : {true, false}) {
    for (const char* const file : {"q.wkt", "q.geojson", "q.vtp"}) {
      std::vector<std::string> arguments{"simplify", "square", "--tolerance", "0", "-o", file};
      if (!closed) arguments.emplace_back("--no-closed");
      const Outcome found = run(arguments);
      EXPECT_EQ(found.status, 0) << found.err;
    }
    EXPECT_TRUE(read("q.wkt").starts_with(closed ? "POLYGON ((" : "LINESTRING (")) << read("q.wkt");
    EXPECT_NE(read("q.geojson").find(closed ? "\"Polygon\"" : "\"LineString\""), std::string::npos);
    EXPECT_NE(read("q.vtp").find(closed ? "NumberOfPolys=\"1\"" : "NumberOfPolys=\"0\""), std::string::npos);
  }
}

// Both forms of a sweep end alike.
TEST_F(OperationCommand, ValuesThatFailAreInTheStatus) {
  const std::string range = "k=-2:1:3";  // at -2 there is no saddle
  const Outcome table = run({"sweep", "henon", "--range", range}), own = run({"transport", "henon", "--sweep", range});
  EXPECT_EQ(table.status, 1);
  EXPECT_EQ(own.status, 1);
  EXPECT_NE(table.err.find("1 of 2 values failed, the first at k = -2"), std::string::npos) << table.err;
  EXPECT_NE(table.out.find("\nrows\n"), std::string::npos) << table.out;
  // The reason is whole below the table, and short in it.
  const std::size_t cell = table.out.find("..."), whole = table.out.find("\n  failure at value = -2: ");
  ASSERT_NE(cell, std::string::npos) << table.out;
  ASSERT_NE(whole, std::string::npos) << table.out;
  EXPECT_LT(cell, whole);
}

TEST_F(OperationCommand, NamesTheFileOfACurveThatCrossesItself) {
  const std::vector<Point> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, line{{0, 1}, {3, 1}};
  write_curve("bow", bow);
  write_curve("line", line);
  const Outcome found = run({"curve-transport", "line", "bow"});
  EXPECT_EQ(found.status, 1);
  EXPECT_NE(found.err.find("bow: curve 2 is not simple"), std::string::npos) << found.err;
}

// The path from (1.05, 0) to (0, 0) crosses the wave.
TEST_F(OperationCommand, SaysOnceThatABoundaryCrossesItself) {
  std::vector<Point> wave, arc;
  for (int k = 0; k <= 400; ++k) wave.push_back({k / 400.0, 0.3 * std::sin(5 * std::numbers::pi * k / 400)});
  for (int k = 100; k >= 0; --k) arc.push_back({1.05 * k / 100, -0.05 * std::sin(std::numbers::pi * k / 100)});
  write_curve("wave", wave);
  write_curve("arc", arc);
  const std::string crosses_itself = "the boundary crosses itself";
  const Outcome tangle = run({"tangle", "wave", "arc", "--smooth", "--json", "-"});
  const std::size_t said_of_lobes = tangle.err.find(crosses_itself);
  ASSERT_NE(said_of_lobes, std::string::npos) << tangle.err;
  EXPECT_EQ(tangle.err.find(crosses_itself, said_of_lobes + 1), std::string::npos) << tangle.err;
  EXPECT_NE(tangle.err.find("L12, L21"), std::string::npos) << tangle.err;
  const Json boundary = Json::parse(tangle.out)["boundary"];
  const std::vector<std::vector<std::string>> commands{{"curve-transport"}, {"transport", "--manifolds"}};
  for (std::vector<std::string> arguments : commands) {
    arguments.insert(arguments.end(), {"wave", "arc", "--json", "-"});
    const Outcome found = run(arguments);
    EXPECT_EQ(found.status, 3) << found.err;  // no map that preserves area has such lobes
    for (const std::string& said : {std::string("U begins at (0, 0)"), crosses_itself}) {
      const std::size_t first = found.err.find(said);
      ASSERT_NE(first, std::string::npos) << found.err;
      EXPECT_EQ(found.err.find(said, first + 1), std::string::npos) << found.err;
    }
    const Json regions = Json::parse(found.out)["regions"];
    EXPECT_EQ(regions[0]["area"], boundary["area"]) << regions;
  }
}

TEST_F(OperationCommand, SaysNothingOfABoundaryThatDoesNotCrossItself) {
  std::vector<Point> wave, arc;
  for (int k = 0; k <= 400; ++k) wave.push_back({k / 400.0, 0.3 * std::sin(5 * std::numbers::pi * k / 400)});
  for (int k = 100; k >= 0; --k) arc.push_back({1.05 * k / 100, -0.05 * std::sin(std::numbers::pi * k / 100)});
  write_curve("wave", wave);
  write_curve("arc", arc);
  const Outcome tangle = run({"tangle", "wave", "arc", "--smooth", "--closure", "1.05,-0.5,0,-0.5"});
  EXPECT_EQ(tangle.status, 3) << tangle.err;
  EXPECT_EQ(tangle.err.find("crosses itself"), std::string::npos) << tangle.err;
}

TEST_F(OperationCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(run({"regions"}).status, 2);
  EXPECT_EQ(run({"regions", "eight", "box", "--passes", "3"}).status, 2);
  EXPECT_EQ(run({"regions", "none"}).status, 1);
  const Outcome misspelt = run({"regoins", "eight", "box"});
  EXPECT_EQ(misspelt.status, 2);
  EXPECT_NE(misspelt.err.find("did you mean regions?"), std::string::npos) << misspelt.err;
  EXPECT_EQ(run({"regions", "eight", "--json", "eight"}).status, 2);  // an input
  const Outcome nowhere = run({"regions", "eight", "--json", "none/x.json"});
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_NE(nowhere.err.find("none/x.json: cannot be written"), std::string::npos) << nowhere.err;
}

}  // namespace
}  // namespace lober::cli
