// `lober overlay` on pairs with known answers, and all its outputs.

#include <algorithm>
#include <cstring>
#include <sstream>

#include "engine/base/text.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"
#include "tests/paths.hpp"
#include "tests/views.hpp"

namespace lober::cli {
using namespace lober::detail;
namespace {

class OverlayProgram : public ProgramTest {
 protected:
  // Areas of C1 \ C2 and C2 \ C1.
  std::pair<double, double> differences(const std::vector<Point>& c1, const std::vector<Point>& c2) {
    write_curve("c1", c1);
    write_curve("c2", c2);
    const Json areas = overlay({"c1", "c2"})["areas"];
    return {areas["c1_minus_c2"], areas["c2_minus_c1"]};
  }
};

// Cases that Lober 1.8 gets wrong.
TEST_F(OverlayProgram, GetsSharedSidesRight) {
  using Pair = std::pair<double, double>;
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(0, 0, 2, 1)), Pair(0, 1));
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(0.5, 0, 1.5, 1)), Pair(0.5, 0.5));
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(1, 0.25, 2, 0.75)), Pair(1, 0.5));
  EXPECT_EQ(differences(box(0, 2, 6, 4), box(2, 0, 4, 6)), Pair(8, 8));
  const std::vector<Point> curve = flower(64, 3, 0.25, {0, 0});
  EXPECT_EQ(differences(curve, curve), Pair(0, 0));
  EXPECT_EQ(differences(box(0, 0, 2, 2), {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), Pair(0, 0));
}

// A square with a smaller one inside, which is a hole of C1 \ C2, and a flower that cuts another.
TEST_F(OverlayProgram, PutsRingsIntoTheJson) {
  write_curve("outer", box(0, 0, 4, 4));
  write_curve("inner", box(1, 1, 2, 3));
  write_curve("flower", flower(400, 5, 0.4, {3, 3}));
  for (const char* other : {"inner", "flower"}) {
    const Json result = overlay({"outer", other, "--rings"});
    for (const auto& [pairing, pieces] : result["pieces"].items()) {
      ASSERT_EQ(pieces.size(), result["rings"][pairing].size()) << pairing;
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Json& rings = result["rings"][pairing][k];
        EXPECT_EQ(rings.size(), 1 + pieces[k]["holes"].get<std::size_t>());
        double area = 0;
        for (const Json& ring : rings) {
          std::vector<Point> points;
          for (const Json& point : ring) points.push_back({point[0], point[1]});
          const ClosedCurve curve(points);
          area += (&ring == &rings[0] ? 1 : -1) * std::fabs(signed_area(curve));
        }
        EXPECT_NEAR(area, pieces[k]["area"].get<double>(), 1e-13) << pairing << ' ' << k;
      }
    }
  }
  const Outcome refused = run({"overlay", "outer", "inner", "--rings"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--rings needs --json"), std::string::npos) << refused.err;
}

// The columns of the structured array are those of the CSV.
TEST_F(OverlayProgram, WritesCrossingsAsAnArray) {
  write_curve("c1", flower(200, 5, 0.4, {0, 0}));
  write_curve("c2", flower(300, 7, 0.3, {0.1, 0.2}));
  for (const bool classes : {false, true}) {
    std::vector<std::string> arguments{"overlay", "c1", "c2", "--crossings"};
    if (classes) arguments.insert(arguments.begin() + 3, "--classes");
    for (const char* name : {"x.csv", "x.npy"}) {
      std::vector<std::string> all = arguments;
      all.emplace_back(name);
      ASSERT_EQ(run(all).status, 0);
    }
    std::istringstream csv(read("x.csv"));
    std::vector<std::string> rows;
    std::string columns, line;
    while (std::getline(csv, line)) {
      if (line.front() == '#') continue;
      columns.empty() ? columns = line : rows.emplace_back(line);
    }
    const std::string array = read("x.npy");
    const std::size_t head = array.find('\n') + 1;
    ASSERT_EQ(head % 64, 0U);
    ASSERT_GE(rows.size(), 10U);
    std::string names;
    for (std::size_t at = array.find("('"); at < head; at = array.find("('", at + 2)) {
      if (array[at + 2] < 'a') continue;  // the shape
      names += (names.empty() ? "" : ",") + array.substr(at + 2, array.find('\'', at + 2) - at - 2);
    }
    EXPECT_EQ(names, columns);
    ASSERT_EQ((array.size() - head) % rows.size(), 0U);
    const std::size_t row = (array.size() - head) / rows.size();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      std::int64_t index = 0;
      Point point;
      std::memcpy(&index, array.data() + head + k * row, sizeof index);
      std::memcpy(&point, array.data() + head + k * row + sizeof index, sizeof point);
      EXPECT_TRUE(rows[k].starts_with(std::to_string(index) + "," + detail::format_number(point.x) + "," +
                                      detail::format_number(point.y) + ","))
          << rows[k];
    }
  }
}

TEST_F(OverlayProgram, TakesEitherOrientationAndAClosingVertex) {
  write("c1", "0 0\n0 1\n1 1\n1 0\n0 0\n");
  write_curve("c2", box(0.5, 0.5, 1.5, 1.5));
  const Json result = overlay({"c1", "c2"});
  EXPECT_EQ(result["inputs"][0]["points"], 4);
  EXPECT_EQ(result["inputs"][0]["orientation"], "clockwise");
  EXPECT_EQ(result["inputs"][0]["area"], -1.0);
  EXPECT_EQ(result["inputs"][1]["orientation"], "counter_clockwise");
  EXPECT_EQ(result["areas"]["intersection"], 0.25);
}

TEST_F(OverlayProgram, TakesColumnsAndGroupsOfATable) {
  write("table.csv", "id,t,x,y\na,0,0,0\nb,0,0,0\na,1,1,0\nb,1,3,0\na,2,1,1\nb,2,3,3\na,3,0,1\nb,3,0,3\n");
  EXPECT_EQ(overlay({"table.csv:x,y,by=id#a", "table.csv:3,4,by=1#1"})["areas"]["c2_minus_c1"], 8.0);
  write("curves.txt", "> small\n0 0\n1 0\n1 1\n0 1\n> large\n0 0\n3 0\n3 3\n0 3\n");
  EXPECT_EQ(overlay({"curves.txt#small", "curves.txt#large"})["areas"]["c2_minus_c1"], 8.0);
  const Outcome unnamed = run({"overlay", "table.csv", "curves.txt#0"});
  EXPECT_EQ(unnamed.status, 1);
  EXPECT_NE(unnamed.err.find("expected two columns, found 4: id, t, x, y; choose two by FILE:NAME,NAME"),
            std::string::npos)
      << unnamed.err;
}

TEST_F(OverlayProgram, TakesZonesByNumberAndByTitle) {
  write("zones.dat",
        "VARIABLES=\"x\"\"y\"\nZONE T=\"small\"\n0 0\n1 0\n1 1\n0 1\nZONE T=\"large\"\n0 0\n3 0\n3 3\n0 3\n");
  const Json result = overlay({"zones.dat#0", "zones.dat#large"});
  EXPECT_EQ(result["inputs"][0]["zone"], 0);
  EXPECT_EQ(result["inputs"][1]["zone"], 1);
  EXPECT_EQ(result["inputs"][1]["file"], "zones.dat");
  EXPECT_EQ(result["areas"]["c2_minus_c1"], 8.0);
  const Outcome table = run({"overlay", "zones.dat#0", "zones.dat#1"});
  EXPECT_NE(table.out.find("zones.dat#1"), std::string::npos) << table.out;
}

TEST_F(OverlayProgram, PrintsAShortTable) {
  write_curve("c1", flower(2000, 40, 0.1, {0, 0}));
  write_curve("c2", flower(2000, 40, -0.1, {0, 0}));
  const Outcome outcome = run({"overlay", "c1", "c2"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");  // no progress bar where there is no terminal
  EXPECT_NE(outcome.out.find("80 crossings, 0 touches, 0 shared arcs"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("C1 \\ C2: 40 lobes"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("and 30 more"), std::string::npos) << outcome.out;
  EXPECT_LT(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 45);
}

TEST_F(OverlayProgram, TellsPhasesOnStandardErrorWhenAsked) {
  write_curve("c1", box(0, 0, 1, 1));
  write_curve("c2", box(0.5, 0.5, 2, 2));
  const Outcome outcome = run({"overlay", "c1", "c2", "--verbose", "--json", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("crossings"), std::string::npos);
  EXPECT_TRUE(Json::accept(outcome.out));
}

TEST_F(OverlayProgram, WritesLobesThatItCanRead) {
  write_curve("outer", box(0, 0, 10, 10));
  write_curve("inner", box(2, 2, 4, 12));
  EXPECT_EQ(run({"overlay", "outer", "inner", "--lobes", "lobes.dat"}).status, 0);
  const CurveFile file = read_curve_file(folder() / "lobes.dat");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[0].title, "c1_minus_c2 0 area=84");
  EXPECT_EQ(file.zones[1].title, "c2_minus_c1 0 area=4");
  EXPECT_EQ(signed_area({file.zones[0].points}), 84);
  EXPECT_EQ(signed_area({file.zones[1].points}), 4);
  EXPECT_EQ(overlay({"lobes.dat#0", "outer"})["areas"]["c1_minus_c2"], 0.0);
}

TEST_F(OverlayProgram, WritesHolesAsZonesOfTheirOwn) {
  write_curve("outer", box(0, 0, 10, 10));
  write_curve("inner", box(2, 2, 4, 4));
  EXPECT_EQ(run({"overlay", "outer", "inner", "--lobes", "lobes.dat"}).status, 0);
  const CurveFile file = read_curve_file(folder() / "lobes.dat");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[0].title, "c1_minus_c2 0 area=96");
  EXPECT_EQ(file.zones[1].title, "c1_minus_c2 0 hole 1");
  EXPECT_EQ(signed_area({file.zones[0].points}) + signed_area({file.zones[1].points}), 96);
}

TEST_F(OverlayProgram, WritesCrossingsAsColumns) {
  write_curve("c1", box(0, 0, 2, 2));
  write_curve("c2", box(1, 0, 3, 1));
  EXPECT_EQ(run({"overlay", "c1", "c2", "--crossings", "crossings.csv"}).status, 0);
  const std::string text = read("crossings.csv");
  const std::size_t rows = text.find("\nindex,x,y,rho,kind,segment1,t1,segment2,t2,class,order2,end_x");
  ASSERT_NE(rows, std::string::npos) << text;
  EXPECT_TRUE(text.starts_with("#"));
  const std::string body = text.substr(text.find('\n', rows + 1) + 1);
  EXPECT_EQ(body,
            "0,1,0,-1,shared_arc,0,0.5,0,0,0,0,2,0,1,0,0,0.5\n"
            "1,2,1,1,crossing,1,0.5,2,0.5,0,1,,,,,,\n");
}

TEST_F(OverlayProgram, DrawsAPicture) {
  write_curve("c1", flower(20000, 7, 0.2, {0, 0}));
  write_curve("c2", flower(20000, 5, 0.2, {0.1, 0}));
  EXPECT_EQ(run({"overlay", "c1", "c2", "--svg", "picture.svg"}).status, 0);
  const std::string svg = read("picture.svg");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_NE(svg.find("<circle"), std::string::npos);
  EXPECT_LT(svg.size(), 200'000U);  // vertices that could not be told apart are left out
}

TEST_F(OverlayProgram, LeavesNoTemporaryFiles) {
  write_curve("c1", box(0, 0, 2, 2));
  write_curve("c2", box(1, 1, 3, 3));
  EXPECT_EQ(run({"overlay", "c1", "c2", "--json", "j", "--lobes", "l", "--crossings", "c", "--svg", "s"}).status, 0);
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{".streams", "c", "c1", "c2", "j", "l", "s"}));
}

// Tables 1 to 4 of Naik, Lekien & Ross (2017), on the curves of examples/.
TEST_F(ProgramTest, OverlayTellsClasses) {
  const std::string curves = std::string(LOBER_SOURCE_DIR) + "/examples/six-crossings.dat";
  const Outcome text =
      run({"overlay", curves + "#C1", curves + "#C2", "--classes", "--crossings", "table.csv", "--json", "table.json"});
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("C1 \\ C2: 2 classes; half the sum of S is 6\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("C2 \\ C1: 2 classes; half the sum of S is 29\n"), std::string::npos) << text.out;
  // The row of p3 in the table of gamma.
  EXPECT_NE(text.out.find("   gamma   0   1   2   3   4   5\n       0   0   1   0   0   0   0\n"), std::string::npos)
      << text.out;
  const nlohmann::json result = nlohmann::json::parse(read("table.json"));
  EXPECT_EQ(result["sigma"]["c1_minus_c2"]["classes"], 2);
  EXPECT_EQ(result["sigma"]["c1_minus_c2"]["list"][3],
            nlohmann::json::parse(R"({"crossing":3,"rho":-1,"along1":4,"along2":4,"sigma":4,"class":1,"s":-2.0})"));
  EXPECT_EQ(result["sigma"]["c2_minus_c1"]["half_sum"], 29.0);
  EXPECT_EQ(result["agreement"], true);
  const std::string table = read("table.csv");
  EXPECT_NE(
      table.find(",end_t2,along1_12,along2_12,sigma_12,class_12,s_12,along1_21,along2_21,sigma_21,class_21,s_21\n"),
      std::string::npos);
  EXPECT_NE(table.find("\n3,4,0,-1,crossing,0,0.5714285714285714,5,0.5,1,2,,,,,,,4,4,4,1,-2,2,2,2,1,-2\n"),
            std::string::npos)
      << table;
  EXPECT_FALSE(overlay({curves + "#C1", curves + "#C2"}).contains("sigma"));
  EXPECT_EQ(run({"overlay", curves + "#C1", curves + "#C2", "--classes", "--rule", "nonzero"}).status, 2);
}

// Coordinates of UTM: the digits that tell the centroids of two lobes of a small eddy apart.
TEST_F(OverlayProgram, CentroidsHaveTheDigitsThatTheExtentNeeds) {
  const std::vector<Point> first{{500000, 5000000}, {500100, 5000000}, {500100, 5000100}, {500000, 5000100}},
      second{{500050, 5000050}, {500150, 5000050}, {500150, 5000150}, {500050, 5000150}};
  write_curve("first", first);
  write_curve("second", second);
  const std::string table = run({"overlay", "first", "second"}).out;
  EXPECT_NE(table.find("500041.667,      5000041.67)"), std::string::npos) << table;
}

}  // namespace
}  // namespace lober::cli
