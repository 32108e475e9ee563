// `lober winding`: winding numbers and J of points and grids.
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "tests/cli/program.hpp"
#include "tests/oracle/random.hpp"

namespace lober::cli {
namespace {

class WindingProgram : public ProgramTest {
 protected:
  [[nodiscard]] Json winding(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "winding");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

// In whole numbers, exactly, along a ray upwards; the engine's goes to the right.
struct Expected {
  int number = 0;
  bool on = false;
};
Expected brute_force(const std::vector<Point>& curve, Point point) {
  Expected expected;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Point a = curve[k], b = curve[(k + 1) % curve.size()];
    // Coordinates are multiples of a half below 2^20: every product is exact.
    const double side = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
    const bool within = std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x) &&
                        std::min(a.y, b.y) <= point.y && point.y <= std::max(a.y, b.y);
    if (side == 0 && within) return {0, true};
    if (a.x <= point.x && point.x < b.x && side < 0) --expected.number;
    if (b.x <= point.x && point.x < a.x && side > 0) ++expected.number;
  }
  return expected;
}

TEST_F(WindingProgram, IsExactAboutVerticesEdgesAndAllElse) {
  oracle::Random random(71);
  std::size_t on = 0, many = 0;
  for (int pass = 0; pass < 10; ++pass) {
    std::vector<Point> curve, points;
    for (int k = 0; k < 40; ++k) {
      curve.push_back({static_cast<double>(random.integer(0, 12)), static_cast<double>(random.integer(0, 12))});
    }
    for (int x = -2; x <= 26; ++x) {
      for (int y = -2; y <= 26; ++y) points.push_back({0.5 * x, 0.5 * y});
    }
    write_curve("walk", curve);
    write_curve("points", points);
    const Json found = winding({"walk", "--at", "points"})["points"];
    ASSERT_EQ(found.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Expected expected = brute_force(curve, points[k]);
      ASSERT_EQ(found[k]["on"], expected.on) << points[k].x << ' ' << points[k].y;
      ASSERT_EQ(found[k]["winding"], expected.number) << points[k].x << ' ' << points[k].y;
      if (!expected.on) {
        ASSERT_NEAR(found[k]["j"].get<double>(), 2 * std::numbers::pi * expected.number, 1e-13);
      }
      on += expected.on ? 1 : 0;
      many += std::abs(expected.number) > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(on, 300U);
  EXPECT_GT(many, 300U);
}

// Points are named as curves are: by columns, by zones.
TEST_F(WindingProgram, ReadsPointsOfColumnsAndZones) {
  write_curve("square", box(0, 0, 2, 2));
  write("drifters.csv", "time,x,y,id\n2020-01-01 00:00:00,1,1,a\n2020-01-01 01:00:00,3,1,b\n,0.5,1.5,a\n");
  EXPECT_EQ(winding({"square", "--at", "drifters.csv:x,y"})["points"].size(), 3U);
  const Json found = winding({"square", "--at", "drifters.csv:x,y,by=id#a", "drifters.csv:2,3,by=4#b"})["points"];
  ASSERT_EQ(found.size(), 3U);
  for (const std::size_t k : {0U, 1U, 2U}) EXPECT_EQ(found[k]["winding"], k < 2 ? 1 : 0);
  const Outcome missing = run({"winding", "square", "--at", "drifters.csv:x,y,by=id#c"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("has no zone titled \"c\""), std::string::npos) << missing.err;
  EXPECT_EQ(run({"winding", "square", "--at", "drifters.csv:x,y", "--json", "drifters.csv"}).status, 2);
}

// Tables have the separator that their ending promises.
TEST_F(WindingProgram, WritesTheGridAsItsEndingSays) {
  write_curve("square", box(0, 0, 2, 2));
  const auto separator = [&](const std::string& file) {
    const Outcome outcome = run({"winding", "square", "--grid", "2,2", "-o", file});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string text = read(file);
    const std::size_t begin = text.find('\n') + 1;
    return text.at(text.find_first_of(", \t\n", begin));
  };
  EXPECT_EQ(separator("a.csv"), ',');
  EXPECT_EQ(separator("a.txt"), ' ');
  EXPECT_EQ(separator("a.TSV"), '\t');
  EXPECT_EQ(separator("a.tec"), '\t');
  const Outcome wrong = run({"winding", "square", "--grid", "2,2", "-o", "a.geojson"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("use .npy, .csv, .txt, .dat (Tecplot) or .f64"), std::string::npos) << wrong.err;
}

TEST_F(WindingProgram, TellsThePrincipalValueOnTheCurve) {
  write_curve("square", box(0, 0, 2, 2));
  const Json found = winding({"square", "--at", "1,0", "2,2", "1,1", "-1,1"});
  using std::numbers::pi;
  EXPECT_EQ(found["on"], 2);
  EXPECT_NEAR(found["points"][0]["j"].get<double>(), pi, 1e-15);      // half a turn on an edge
  EXPECT_NEAR(found["points"][1]["j"].get<double>(), pi / 2, 1e-15);  // the angle at a vertex
  EXPECT_EQ(found["points"][0]["winding"], 0);
  EXPECT_EQ(found["points"][2]["winding"], 1);
  EXPECT_EQ(found["counts"], Json::parse(R"([{"winding":0,"points":1},{"winding":1,"points":1}])"));
  EXPECT_EQ(found["agreement"], true);
  const Outcome text = run({"winding", "square", "--at", "1,0", "1,1"});
  EXPECT_NE(text.out.find(" on     3.14159265358979"), std::string::npos) << text.out;
}

TEST_F(WindingProgram, CountsBothOrientationsOfAFigureOfEight) {
  write_curve("eight", std::vector<Point>{{-2, -1}, {2, 1}, {2, -1}, {-2, 1}});
  const Json found = winding({"eight", "--grid", "400,200", "--box", "-2,-1,2,1"});
  std::map<int, std::size_t> counts;
  for (const Json& entry : found["counts"]) counts[entry["winding"]] = entry["points"];
  // Each loop has a quarter of the box's area.
  EXPECT_EQ(counts[1], counts[-1]);
  EXPECT_EQ(counts[1] + counts[-1] + counts[0] + found["on"].get<std::size_t>(), 80000U);
  EXPECT_NEAR(static_cast<double>(counts[1]), 20000, 300);
  EXPECT_EQ(found["grid"]["columns"], 400);
  EXPECT_EQ(found["grid"]["box"], Json::parse("[-2.0, -1.0, 2.0, 1.0]"));
}

TEST_F(WindingProgram, WritesGridsAndPoints) {
  write_curve("square", box(0, 0, 2, 2));
  const std::vector<std::string> grid{"winding", "square", "--grid", "4,3", "--box", "-1,-1,3,5", "-o"};
  const auto to = [&](const char* name) {
    std::vector<std::string> arguments = grid;
    arguments.emplace_back(name);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read(name);
  };
  EXPECT_EQ(to("field.csv"),
            "x,y,winding,on,j\n"
            "-0.5,0,0,0,0\n0.5,0,0,1,3.141592653589793\n1.5,0,0,1,3.1415926535897936\n2.5,0,0,0,0\n"
            "-0.5,2,0,0,0\n0.5,2,0,1,3.141592653589793\n1.5,2,0,1,3.1415926535897936\n2.5,2,0,0,0\n"
            "-0.5,4,0,0,0\n0.5,4,0,0,0\n1.5,4,0,0,0\n2.5,4,0,0,0\n");
  const std::string npy = to("field.npy");
  EXPECT_NE(npy.find("'shape': (3, 4, 5), }"), std::string::npos) << npy.substr(10, 100);
  ASSERT_EQ(npy.size(), 128U + 3 * 4 * 5 * 8);
  double value = 0;
  std::memcpy(&value, npy.data() + 128 + 8 * (5 * 1 + 4), 8);  // j of the second cell
  EXPECT_EQ(value, std::numbers::pi);
  EXPECT_TRUE(to("field.dat").starts_with("VARIABLES=\"x\"\"y\"\"winding\"\"on\"\"j\"\n-0.5\t0\t0\t0\t0\n"));
  EXPECT_EQ(run({"winding", "square", "--grid", "40,30", "--svg", "field.svg"}).status, 0);
  const std::string svg = read("field.svg");
  EXPECT_NE(svg.find("winding number 1"), std::string::npos);
}

TEST_F(WindingProgram, HasTheSameBytesForAnyNumberOfThreads) {
  write_curve("flower", flower(30000, 31, 1.5, {0, 0}));  // so deep that the petals cross
  std::set<std::string> seen;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome =
        run({"winding", "flower", "--grid", "300,200", "--threads", threads, "-o", "field.npy", "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    seen.insert(without_timing(outcome.out) + read("field.npy"));
  }
  EXPECT_EQ(seen.size(), 1U);
}

TEST_F(WindingProgram, RefusesWhatMakesNoSense) {
  write_curve("square", box(0, 0, 2, 2));
  write("open", "0 0\n1 1\n");
  write("east.csv", "lon,lat\n0,0\n2,0\n2,1\n");
  write("north.csv", "lat,lon\n0.5,1\n0.2,1\n");
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& words) {
    arguments.insert(arguments.begin(), "winding");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused({"square"}, 2, "give --at or --grid");
  refused({"square", "--at", "1,1", "--grid", "3,3"}, 2, "--grid");
  refused({"square", "--grid", "3"}, 2, "--grid");
  refused({"square", "--grid", "0,3"}, 2, "--grid");
  refused({"square", "--grid", "100000,100000"}, 2, "at most 100000000 cells");
  refused({"square", "--grid", "3,3", "--box", "0,0,0,1"}, 2, "X0 < X1");
  refused({"square", "--at", "1,1", "--box", "0,0,1,1"}, 2, "--box needs --grid");
  refused({"square", "--at", "inf,1"}, 2, "not a finite point");
  refused({"square", "--at", "nowhere"}, 1, "nowhere: ");
  refused({"open", "--at", "1,1"}, 1, "open: ");
  refused({"east.csv", "--at", "north.csv"}, 1, "the columns of north.csv are latitude and longitude");
  refused({"square", "--at", "1,1", "-o", "out.json"}, 2, "out.json");
  refused({"square", "--at", "1,1", "-o", "square.csv", "--json", "square.csv"}, 2, "both write");
  refused({"square", "--at", "square", "--json", "square"}, 2, "overwrite");
}

}  // namespace
}  // namespace lober::cli
