// The third command line of Lober 1.8, on tangles with known answers.

#include <algorithm>
#include <map>
#include <sstream>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class PublishedTangle : public ProgramTest {
 protected:
  void SetUp() override {
    // Zone 0 is something else; zone 1 and 2 are U and the same an eighth higher.
    write("u", "ZONE\n7 7\n8 8\nZONE\n0 0\n10 0\nZONE\n0 0.125\n10 0.125\n");
    write("s", "ZONE\n9 3\n7 -1\n5 1\n3 -1\n1.9 0.1\nZONE\n9 3\n7 -1\n5.5 0.5\n");
  }
  void lober(const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    out_ = outcome.out;
  }
  [[nodiscard]] const std::string& out() const { return out_; }
  void expect_failure(const std::vector<std::string>& arguments, int status, const std::string& words) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(exists("separ.dat"));
  }

 private:
  std::string out_;
};

TEST_F(PublishedTangle, WritesItsFiles) {
  lober({"u", "s", "lobe", "mani", "pips", "1", "0", "1", "lobeb", "one"});
  EXPECT_EQ(read("mani"),
            "VARIABLES=\"x\"\"y\"\nZONE I=2\n0\t0\n10\t0\nZONE I=5\n9\t3\n7\t-1\n5\t1\n3\t-1\n1.9\t0.1\n");
  EXPECT_EQ(read("pips"), "VARIABLES=\"x\"\"y\"\nZONE I=4\n2\t0\n4\t0\n6\t0\n7.5\t0\n");
  EXPECT_EQ(read("separ.dat"), "VARIABLES=\"x\"\"y\"\n0\t0\n6\t0\n7\t-1\n9\t3\n");
  const std::string lobe0 = "ZONE T=\"zone=0 lobe=0\" I=4\n2\t0\n4\t0\n3\t-1\n2\t0\n";
  const std::string lobe1 = "ZONE T=\"zone=0 lobe=1\" I=4\n4\t0\n6\t0\n5\t1\n4\t0\n";
  const std::string lobe2 = "ZONE T=\"zone=0 lobe=2\" I=4\n6\t0\n7.5\t0\n7\t-1\n6\t0\n";
  EXPECT_EQ(read("lobeb"), "VARIABLES=\"x\"\"y\"\n" + lobe0 + lobe1 + lobe2);
  EXPECT_EQ(read("one0.dat"), "VARIABLES=\"x\"\"y\"\n" + lobe0);
  EXPECT_EQ(read("one2.dat"), "VARIABLES=\"x\"\"y\"\n" + lobe2);
  EXPECT_FALSE(exists("one3.dat"));
}

TEST_F(PublishedTangle, PrintsPipsAndAreas) {
  lober({"u", "s", "lobe", "mani", "pips", "1", "0", "2"});
  std::istringstream table(out());
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "zone 0: 4 pips, 3 lobes, bip 2");
  std::getline(table, line);
  double number = 0, x = 0, y = 0;
  for (const double expected : {2.0, 4.0, 6.0, 7.5}) {
    ASSERT_TRUE(table >> number >> x >> y) << out();
    EXPECT_EQ(x, expected);
    EXPECT_EQ(y, 0);
  }
  std::getline(table, line);
  std::getline(table, line);
  for (const double expected : {-1.0, 1.0, -0.75}) {
    ASSERT_TRUE(table >> number >> x >> y) << out();
    EXPECT_EQ(x, expected);
    EXPECT_GT(y, 0);
  }
  EXPECT_NE(out().find("\nzone 1: 2 pips, 1 lobe, bip 1\n"), std::string::npos) << out();
}

// Cells of 0.055 x 0.02: 100 x 100 for the window [2, 7.5] x [-1, 1].
TEST_F(PublishedTangle, PaintsLobesOnAGrid) {
  lober({"u", "s", "lobe", "mani", "pips", "1", "0", "1"});
  std::istringstream file(read("lobe"));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "VARIABLES=\"x\"\"y\"\"lobe\"");
  std::getline(file, line);
  EXPECT_EQ(line, "ZONE T=\"zone=0\" I=100 J=100 F=POINT");
  std::map<int, int> cells;
  double x = 0, y = 0, first_x = 0, first_y = 0;
  int number = 0, count = 0;
  while (file >> x >> y >> number) {
    if (count == 0) first_x = x, first_y = y;
    EXPECT_NEAR(x, 2 + 0.055 * (count % 100 + 0.5), 1e-12);
    EXPECT_NEAR(y, -1 + 0.02 * (count / 100 + 0.5), 1e-12);
    ++cells[number];
    ++count;
  }
  EXPECT_EQ(count, 10'000);
  EXPECT_NEAR(first_x, 2.0275, 1e-12);
  EXPECT_NEAR(first_y, -0.99, 1e-12);
  const double cell = 0.055 * 0.02;
  EXPECT_EQ(cells.size(), 4U);  // nothing but these and 0
  EXPECT_NEAR(cells[-1] * cell, 1, 0.02);
  EXPECT_NEAR(cells[2] * cell, 1, 0.02);
  EXPECT_NEAR(cells[-3] * cell, 0.75, 0.02);
}

TEST_F(PublishedTangle, TakesSeveralZonesAndABip) {
  lober({"u", "s", "lobe", "mani", "pips", "1", "0", "2", "lobeb", "one", "-BIP", "1"});
  const CurveFile lobes = read_curve_file(folder() / "lobeb");
  ASSERT_EQ(lobes.zones.size(), 4U);
  EXPECT_EQ(lobes.zones[2].title, "zone=0 lobe=2");
  EXPECT_EQ(lobes.zones[3].title, "zone=1 lobe=0");
  EXPECT_EQ(read_curve_file(folder() / "mani").zones.size(), 4U);
  EXPECT_EQ(read_curve_file(folder() / "pips").zones.size(), 2U);
  EXPECT_EQ(read_curve_file(folder() / "one3.dat").zones[0].title, "zone=1 lobe=0");
  const CurveFile boundaries = read_curve_file(folder() / "separ.dat");
  ASSERT_EQ(boundaries.zones.size(), 2U);
  EXPECT_EQ(boundaries.zones[0].points[1], (Point{4, 0}));  // pip 1 of the first pair
}

TEST_F(PublishedTangle, RefusesWhatItCannotDo) {
  expect_failure({"u", "s", "a", "b", "c", "1", "0", "3"}, 1, "u: has 3 zones, but 3 from number 1 on");
  expect_failure({"u", "s", "a", "b", "c", "0", "0", "3"}, 1, "s: has 2 zones");
  expect_failure({"u", "nowhere", "a", "b", "c", "1", "0", "1"}, 1, "nowhere");
  expect_failure({"u", "s", "a", "b", "c", "1", "0", "0"}, 2, "<nzones>");
  expect_failure({"u", "s", "a", "b", "c", "x", "0", "1"}, 2, "<uskip>");
  expect_failure({"u", "s", "a", "b", "c", "1", "-1", "1"}, 2, "-1");
  expect_failure({"u", "s", "a", "b", "c", "1", "0", "1", "d", "e", "f"}, 2, "too many arguments");
  expect_failure({"u", "s", "a", "b", "c", "1", "0", "-BIP", "1"}, 2, "missing");
  expect_failure({"u", "s", "a", "b", "c", "1", "0", "1", "-BIP"}, 2, "-BIP");
  expect_failure({"u", "s", "a", "b", "c", "1", "0", "1", "-BIP", "9"}, 2, "no pip 9");
  expect_failure({"u", "s", "a", "a", "c", "1", "0", "1"}, 2, "both write");
  expect_failure({"u", "s", "a", "u", "c", "1", "0", "1"}, 2, "overwrite the input");
  EXPECT_FALSE(exists("a"));
}

}  // namespace
}  // namespace lober::cli
