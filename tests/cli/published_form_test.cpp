// The command line and the files of the published program.

#include <cmath>
#include <sstream>

#include "engine/curve/curve.hpp"
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

}  // namespace
}  // namespace lober::cli
