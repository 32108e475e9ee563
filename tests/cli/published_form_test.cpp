// The command line and the files of Lober 1.8.

#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class PublishedForm : public ProgramTest {
 protected:
  void SetUp() override {
    write("c1.dat", "VARIABLES=''x''''y''\nZONE T=''the curve C1''\n0 0\n2 0\n2 2\n0 2\n");
    write("c2.dat", "VARIABLES=\"x\"\"y\"\n1 1\n3 1\n3 3\n1 3\n1 1\n");
  }
  void lober(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"c1.dat", "c2.dat", "result"});
    const Outcome outcome = run(more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
  }
  std::vector<Point> points(const char* name) { return read_curve_file(folder() / name).zones[0].points; }
};

TEST_F(PublishedForm, WritesFourNumbers) {
  lober();
  const std::string line = read("result");
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  std::istringstream stream(line);
  double minus12 = 0, error12 = 0, minus21 = 0, error21 = 0;
  ASSERT_TRUE(stream >> minus12 >> error12 >> minus21 >> error21) << line;
  EXPECT_EQ(minus12, 3);
  EXPECT_EQ(minus21, 3);
  EXPECT_GT(error12, 0);
  EXPECT_LT(error12, 1e-12);
  EXPECT_GT(error21, 0);
  EXPECT_LT(error21, 1e-12);
}

TEST_F(PublishedForm, WritesSixFilesOfPoints) {
  lober();
  EXPECT_EQ(read("c12.dat"), "VARIABLES=\"x\"\"y\"\n0\t0\n2\t0\n0\t2\n");
  EXPECT_EQ(read("c11.dat"), "VARIABLES=\"x\"\"y\"\n2\t2\n");
  EXPECT_EQ(read("c10.dat"), "VARIABLES=\"x\"\"y\"\n2\t1\n1\t2\n");
  EXPECT_EQ(read("c21.dat"), "VARIABLES=\"x\"\"y\"\n3\t1\n3\t3\n1\t3\n");
  EXPECT_EQ(read("c22.dat"), "VARIABLES=\"x\"\"y\"\n1\t1\n");
  EXPECT_EQ(read("c20.dat"), "VARIABLES=\"x\"\"y\"\n2\t1\n1\t2\n");
}

// As Lober 1.8 does; areas are those of `interior --rule nonzero`.
TEST_F(PublishedForm, LightTakesCurvesThatCrossThemselves) {
  write_curve("c1.dat", std::vector<Point>{{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  write_curve("c2.dat", box(0, -1, 3, 3));
  const Outcome outcome = run({"-light", "c1.dat", "c2.dat", "result"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("c1.dat: curve 1 is not simple"), std::string::npos) << outcome.err;
  std::istringstream stream(read("result"));
  double minus12 = 0, error12 = 0, minus21 = 0, error21 = 0;
  ASSERT_TRUE(stream >> minus12 >> error12 >> minus21 >> error21);
  const Json ruled = Json::parse(run({"interior", "c1.dat", "c2.dat", "--rule", "nonzero", "--json", "-"}).out);
  EXPECT_EQ(minus12, ruled["areas"]["c1_minus_c2"].get<double>());
  EXPECT_EQ(minus21, ruled["areas"]["c2_minus_c1"].get<double>());
  EXPECT_LT(error12, 1e-12);
  EXPECT_EQ(read("c12.dat"), "VARIABLES=\"x\"\"y\"\n4\t4\n4\t0\n0\t4\n");
  EXPECT_EQ(read("c10.dat"), "VARIABLES=\"x\"\"y\"\n0\t0\n3\t3\n3\t1\n1\t3\n0\t3\n");
  EXPECT_EQ(read("c21.dat"), "VARIABLES=\"x\"\"y\"\n0\t-1\n3\t-1\n");
  EXPECT_EQ(read("c20.dat"), "VARIABLES=\"x\"\"y\"\n3\t1\n3\t3\n1\t3\n0\t3\n0\t0\n");
}

TEST_F(PublishedForm, OthersRefuseCurvesThatCrossThemselvesWithAWayOn) {
  write_curve("c1.dat", std::vector<Point>{{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  const Outcome inserted = run({"-light", "c1.dat", "c2.dat", "result", "-DENS", "2", "3"});
  EXPECT_EQ(inserted.status, 1);
  EXPECT_NE(inserted.err.find("lober -light without -DENS and lober interior --rule"), std::string::npos)
      << inserted.err;
  const Outcome overlaid = run({"c1.dat", "c2.dat", "result"});
  EXPECT_EQ(overlaid.status, 1);
  EXPECT_NE(overlaid.err.find("lober overlay --rule and lober -light"), std::string::npos) << overlaid.err;
  const Outcome interior = run({"interior", "c1.dat", "c2.dat"});
  EXPECT_NE(interior.err.find("--rule"), std::string::npos) << interior.err;
}

TEST_F(PublishedForm, PutsSharedArcsOnTheCurve) {
  write_curve("c1.dat", box(0, 0, 1, 1));
  write_curve("c2.dat", box(0, 0, 2, 1));
  lober();
  EXPECT_EQ(read("c10.dat"), "VARIABLES=\"x\"\"y\"\n0\t0\n1\t0\n1\t1\n0\t1\n");
  EXPECT_EQ(read("c20.dat"), "VARIABLES=\"x\"\"y\"\n0\t0\n1\t0\n1\t1\n0\t1\n");
  EXPECT_EQ(read("c12.dat"), "VARIABLES=\"x\"\"y\"\n");
  EXPECT_EQ(read("c21.dat"), "VARIABLES=\"x\"\"y\"\n2\t0\n2\t1\n");
}

TEST_F(PublishedForm, DensifiesNearIntersectionsOnly) {
  lober();
  const std::string plain = read("result");
  lober({"-DENS", "1", "3"});
  EXPECT_EQ(read("result"), plain);
  // Three points on each of the two segments that hold an intersection; one of them is the intersection
  // itself.
  EXPECT_EQ(points("c11.dat").size() + points("c12.dat").size(), 4U + 2 * 2);
  EXPECT_EQ(points("c10.dat").size(), 2U);
  lober({"-DENS", "3", "10"});
  EXPECT_EQ(read("result"), plain);
  EXPECT_EQ(points("c11.dat").size() + points("c12.dat").size(), 4U + 2 * 30);
  double nearest = 1;
  for (const Point& p : points("c11.dat")) nearest = std::min(nearest, std::hypot(p.x - 2, p.y - 1));
  EXPECT_LE(nearest, 2 * std::pow(10.0, -3));
  EXPECT_GT(nearest, 0);
}

TEST_F(PublishedForm, AcceptsZeroPassesAndZeroPoints) {
  lober();
  const std::string plain = read("c12.dat");
  lober({"-DENS", "0", "10"});
  EXPECT_EQ(read("c12.dat"), plain);
  lober({"-DENS", "2", "0"});
  EXPECT_EQ(read("c12.dat"), plain);
}

// [C1 \ C2] and [C2 \ C1] with what is said to be their errors in percent.
std::array<double, 4> numbers(const std::string& line) {
  std::array<double, 4> values{};
  std::istringstream stream(line);
  for (double& value : values) EXPECT_TRUE(stream >> value) << line;
  return values;
}

TEST_F(PublishedForm, LightWritesTheSameFiles) {
  lober();
  std::map<std::string, std::string> files;
  const std::array names{"c12.dat", "c11.dat", "c10.dat", "c21.dat", "c22.dat", "c20.dat"};
  for (const char* name : names) files[name] = read(name);
  const std::array<double, 4> areas = numbers(read("result"));
  lober({"-light"});
  for (const char* name : names) EXPECT_EQ(read(name), files[name]) << name;
  const std::array<double, 4> light = numbers(read("result"));
  EXPECT_EQ(light[0], areas[0]);
  EXPECT_EQ(light[2], areas[2]);
  EXPECT_GT(light[1], 0);
  EXPECT_LT(light[1], 1e-12);
}

TEST_F(PublishedForm, LightIsExactWhereLober18IsNot) {
  const auto light = [&](const std::vector<Point>& c1, const std::vector<Point>& c2) {
    write_curve("c1.dat", c1);
    write_curve("c2.dat", c2);
    lober({"-light"});
    const std::array<double, 4> values = numbers(read("result"));
    return std::pair(values[0], values[2]);
  };
  using Pair = std::pair<double, double>;
  EXPECT_EQ(light(box(0, 0, 1, 1), box(0, 0, 2, 1)), Pair(0, 1));
  EXPECT_EQ(light(box(0, 0, 1, 1), box(0.5, 0, 1.5, 1)), Pair(0.5, 0.5));
  EXPECT_EQ(light(box(0, 0, 1, 1), box(1, 0.25, 2, 0.75)), Pair(1, 0.5));
  EXPECT_EQ(light(box(0, 2, 6, 4), box(2, 0, 4, 6)), Pair(8, 8));
  EXPECT_EQ(light(box(0, 0, 2, 2), {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), Pair(0, 0));
}

TEST_F(PublishedForm, LightWithDensApproximatesAndSaysHowWell) {
  write_curve("c1.dat", flower(100, 3, 0.1, {0, 0}));
  write_curve("c2.dat", flower(90, 5, 0.1, {0.3, 0.1}));
  lober({"-light"});
  const double exact = numbers(read("result"))[0];
  double before = 1;
  for (const std::vector<std::string>& dens : {std::vector<std::string>{"0"}, {"1", "10"}, {"3", "10"}, {"5", "100"}}) {
    std::vector<std::string> options{"-light", "-DENS"};
    options.insert(options.end(), dens.begin(), dens.end());
    lober(options);
    const std::array<double, 4> values = numbers(read("result"));
    const double error = std::fabs(values[0] - exact);
    EXPECT_LT(error, before);
    EXPECT_NEAR(values[1], 100 * error / values[0], 1e-11);
    before = error / 2;
  }
  EXPECT_LT(before, 1e-10);
  lober({"-light", "-DENS", "0"});
  const std::string single = read("result");
  lober({"-light", "-DENS", "0", "10"});
  EXPECT_EQ(read("result"), single);
}

}  // namespace
}  // namespace lober::cli
