// Files as a user has them: writing, reading back, zones by number and title, failures that must leave no
// trace.
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <random>
#include <thread>

#include "curve_testing.hpp"
#include "lober/curve/files.hpp"
#include "tests/shared_data.hpp"

namespace lober {
namespace {

using test::error_of;
using test::same_bits;

class Files : public test::FolderTest {};

std::string read_file_error(const std::string& path) {
  return error_of([&] { static_cast<void>(read_curve_file(path)); });
}

std::string read_curve_error(const std::string& spec, bool closed = true) {
  return error_of([&] { static_cast<void>(read_curve(spec, closed)); });
}

/// Numbers of every magnitude, denormals and both zeros among them.
std::vector<Point> wild_points(std::size_t count) {
  std::mt19937_64 random(11);
  const auto finite = [&] {
    for (;;) {
      const auto value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  std::vector<Point> points{{0.0, -0.0},
                            {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()}};
  while (points.size() < count) points.push_back({finite(), static_cast<double>(random() % 1000) / 7});
  return points;
}

TEST_F(Files, EveryWriterIsReadBackBitForBit) {
  for (const std::size_t count : {1UL, 2UL, 3UL, 8191UL, 8192UL, 8193UL, 50000UL}) {
    std::vector<Point> points = wild_points(count);
    points.resize(count);
    for (const char separator : {' ', '\t', ',', ';'}) {
      write_text(path("text"), points, separator);
      const CurveFile file = read_curve_file(path("text"));
      EXPECT_EQ(file.format, Format::text);
      EXPECT_TRUE(same_bits(file.zones.at(0).points, points)) << count;
    }
    write_npy(path("npy"), points);
    EXPECT_EQ(read_curve_file(path("npy")).format, Format::npy);
    EXPECT_TRUE(same_bits(read_curve_file(path("npy")).zones.at(0).points, points)) << count;
    write_raw(path("raw.f64"), points);  // numbers like these are only taken for raw ones on request
    EXPECT_EQ(read_curve_file(path("raw.f64")).format, Format::raw);
    EXPECT_TRUE(same_bits(read_curve_file(path("raw.f64")).zones.at(0).points, points)) << count;
    const std::vector<Zone> zones{{"first \"one\"", points, 1}, {"", {{1, 2}}, 1}, {"last", points, 1}};
    write_tecplot(path("tecplot"), zones);
    const CurveFile file = read_curve_file(path("tecplot"));
    EXPECT_EQ(file.format, Format::tecplot);
    ASSERT_EQ(file.zones.size(), zones.size());
    for (std::size_t k = 0; k < zones.size(); ++k) {
      EXPECT_EQ(file.zones[k].title, zones[k].title);
      EXPECT_TRUE(same_bits(file.zones[k].points, zones[k].points)) << k;
    }
  }
  EXPECT_EQ(files(), 4);
}

TEST_F(Files, WritesTheFormatsAsDocumented) {
  const std::vector<Point> points{{1, -0.5}, {1e300, 0.1}};
  write_text(path("a"), points, ',');
  EXPECT_EQ(content(path("a")), "1,-0.5\n1e+300,0.1\n");
  write_tecplot(path("a"), std::vector<Zone>{{"", points, 1}});
  EXPECT_EQ(content(path("a")), "VARIABLES=\"x\"\"y\"\n1\t-0.5\n1e+300\t0.1\n");
  write_tecplot(path("a"), std::vector<Zone>{{"u", points, 1}, {"", {}, 1}});
  EXPECT_EQ(content(path("a")), "VARIABLES=\"x\"\"y\"\nZONE T=\"u\" I=2\n1\t-0.5\n1e+300\t0.1\nZONE I=0\n");
  write_npy(path("a"), points);
  EXPECT_EQ(content(path("a")).size(), 128U + 32U);
  EXPECT_EQ(content(path("a")).substr(10, 60), "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), } ");
  EXPECT_THROW(write_text(path("a"), points, 'x'), UsageError);
}

TEST_F(Files, WhatIsNotFiniteIsNotWritten) {
  const std::string old = put("old", "old");
  const std::vector<Point> points{{1, 2}, {3, std::numeric_limits<double>::quiet_NaN()}};
  const std::string message = old + ": cannot be written: point 1 is not a finite number";
  EXPECT_EQ(error_of([&] { write_text(old, points); }), message);
  EXPECT_EQ(error_of([&] { write_npy(old, points); }), message);
  EXPECT_EQ(error_of([&] { write_raw(old, points); }), message);
  EXPECT_EQ(error_of([&] { write_tecplot(old, std::vector<Zone>{{"", points, 1}}); }), message);
  EXPECT_EQ(content(old), "old");
}

TEST_F(Files, AFailureLeavesTheOldFileAndNothingElse) {
  const std::string old = put("old", "old content");
  // The kernel refuses to let a file grow beyond the limit, as a full disk would.
  ASSERT_NE(std::signal(SIGXFSZ, SIG_IGN), SIG_ERR);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit tight = before;
  tight.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  const std::string message = error_of([&] { write_raw(old, wild_points(100000)); });
  const std::string text_message = error_of([&] { write_text(old, wild_points(100000)); });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(message, old + ": cannot be written: File too large");
  EXPECT_EQ(text_message, message);
  EXPECT_EQ(content(old), "old content");
  EXPECT_EQ(files(), 1);
}

TEST_F(Files, WriteFileReplacesAndKeepsTheMode) {
  const std::string file = put("a", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  write_file(file, "new");
  EXPECT_EQ(content(file), "new");
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_EQ(files(), 1);
}

TEST_F(Files, WriteFileFollowsLinks) {
  const std::string file = put("a", "old");
  std::filesystem::create_symlink("a", path("link"));
  write_file(path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(content(file), "new");
}

TEST_F(Files, WriteFileSaysWhatIsWrong) {
  EXPECT_EQ(error_of([&] { write_file(path("no/a"), ""); }),
            path("no/a") + ": cannot be written: No such file or directory");
  EXPECT_EQ(error_of([&] { write_file(path(""), ""); }), path("") + ": cannot be written: Is a directory");
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_EQ(error_of([&] { write_file("/dev/full", "x"); }), "/dev/full: cannot be written: No space left on device");
  }
}

TEST_F(Files, PipesAreReadAndWrittenStraightThrough) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<Point> points = wild_points(20000);
  std::thread writer([&] { write_text(pipe, points); });
  const CurveFile file = read_curve_file(pipe);
  writer.join();
  EXPECT_TRUE(same_bits(file.zones.at(0).points, points));
  EXPECT_EQ(files(), 1);
}

TEST_F(Files, ADashIsStandardInput) {
  const std::vector<Point> points = wild_points(20000);
  write_text(path("in"), points);
  const int saved = ::dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(path("in").c_str(), "r", stdin), nullptr);
  const CurveFile file = read_curve_file("-");
  if (saved >= 0) {
    ::dup2(saved, STDIN_FILENO);
    ::close(saved);
  }
  EXPECT_TRUE(same_bits(file.zones.at(0).points, points));
}

TEST_F(Files, ADescriptorOfTheProcessKeepsItsPlaceInTheFile) {
  std::FILE* const stream = std::fopen(path("out").c_str(), "w");
  ASSERT_NE(stream, nullptr);
  std::fputs("before\n", stream);
  std::fflush(stream);
  write_file("/dev/fd/" + std::to_string(::fileno(stream)), "between\n");
  std::fputs("after\n", stream);
  std::fclose(stream);
  EXPECT_EQ(content(path("out")), "before\nbetween\nafter\n");
}

TEST_F(Files, ReadingSaysWhatIsWrong) {
  EXPECT_EQ(read_file_error(path("missing")), path("missing") + ": No such file or directory");
  EXPECT_EQ(read_file_error(path("")), path("") + ": is a directory");
  EXPECT_EQ(read_file_error(put("empty", "")), path("empty") + ": the file is empty");
  EXPECT_EQ(read_file_error(put("bad", "1 2\n3\n")), path("bad") + ":2: expected two columns, found 1");
}

TEST_F(Files, TheHashIsThatOfTheWholeFile) {
  EXPECT_EQ(read_curve_file(put("a", "1 2\n3 4\n")).sha256, sha256(test::bytes_of("1 2\n3 4\n")));
  EXPECT_EQ(read_curve_file(path("a"), {.hash = false}).sha256, "");
  write_text(path("big"), wild_points(50000));
  EXPECT_EQ(read_curve_file(path("big")).sha256, sha256(test::bytes_of(content(path("big")))));
}

TEST_F(Files, ZonesAreChosenByNumberOrTitle) {
  const std::string file = put("f",
                               "ZONE T=\"a\"\n0 0\n1 0\n0 1\n0 0\nZONE T=\"b#1\"\n0 0\n2 0\n0 1\nZONE "
                               "T=\"b\"\n0 0\n3 0\n0 1\nZONE T=\"b\"\n0 0\n4 0\n0 1\n");
  const NamedCurve first = read_curve(file + "#0", true);
  EXPECT_EQ(first.curve.points, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(first.curve.name, "a");
  EXPECT_EQ(first.file, file);
  EXPECT_EQ(first.zone, 0U);
  EXPECT_EQ(first.zones, 4U);
  EXPECT_EQ(first.sha256.size(), 64U);
  EXPECT_EQ(read_curve(file + "#a", false).curve.points.size(), 4U);
  EXPECT_EQ(read_curve(file + "#b#1", true).curve.points[1].x, 2);
  EXPECT_EQ(read_curve(file + "#2", true).zone, 2U);
  EXPECT_EQ(read_curve_error(file), file + ": has 4 zones; choose one with " + file + "#0 to " + file +
                                        "#3, or by its title: \"a\", \"b#1\", \"b\"");
  EXPECT_EQ(read_curve_error(file + "#4"), file + ": has no zone 4, only " + file + "#0 to " + file + "#3");
  EXPECT_EQ(read_curve_error(file + "#c"), file + ": has no zone titled \"c\"; there are \"a\", \"b#1\", \"b\"");
  EXPECT_EQ(read_curve_error(file + "#b"),
            file + ": has several zones titled \"b\"; choose one of " + file + "#0 to " + file + "#3");
  EXPECT_EQ(read_curve_error(path("missing") + "#1"), path("missing") + ": No such file or directory");
}

// Eight of them at most, and no control characters.
TEST_F(Files, TitlesOfZonesAreNamed) {
  std::string text;
  for (const char* const title : {"a\tb", "b", "c", "d", "e", "f", "g", "h", "i", "j"}) {
    text += std::string("> ") + title + "\n0 0\n1 0\n0 1\n";
  }
  const std::string many = put("many", text);
  const std::string eight = R"("a?b", "b", "c", "d", "e", "f", "g", "h")";
  EXPECT_EQ(read_curve_error(many), many + ": has 10 zones; choose one with " + many + "#0 to " + many +
                                        "#9, or by its title: " + eight + " and 2 more");
  EXPECT_EQ(read_curve_error(many + "#xyz"), many + ": has no zone titled \"xyz\"; there are " + eight + " and 2 more");
  const std::string week = put("week", "> monday\n0 0\n1 0\n0 1\n> friday\n0 0\n1 0\n0 1\n");
  EXPECT_EQ(read_curve_error(week + "#tuesday"),
            week + ": has no zone titled \"tuesday\"; there are \"monday\", \"friday\"");
  EXPECT_EQ(read_curve_error(week + "#frday"), week + ": has no zone titled \"frday\"; did you mean friday?");
  // Without titles, or with no others than positions, there is nothing to name.
  const std::string plain = put("plain", "0 0\n1 0\n0 1\n\n0 0\n1 0\n0 1\n");
  EXPECT_EQ(read_curve_error(plain), plain + ": has 2 zones; choose one with " + plain + "#0 to " + plain + "#1");
  EXPECT_EQ(read_curve_error(plain + "#a"),
            plain + ": has no zone titled \"a\", only " + plain + "#0 to " + plain + "#1");
  const std::string numbered = put("numbered", "x,y,curve\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n1,0,1\n0,1,1\n");
  EXPECT_EQ(read_curve_error(numbered),
            numbered + ": has 2 zones; choose one with " + numbered + "#0 to " + numbered + "#1");
}

TEST_F(Files, ANameWithTheMarkIsFoundFirst) {
  const std::string file = put("f#0", "0 0\n1 0\n0 1\n");
  EXPECT_EQ(read_curve(file, true).file, file);
  EXPECT_EQ(read_curve(file, true).curve.name, file);
  EXPECT_EQ(read_curve(file + "#0", true).file, file);
  EXPECT_EQ(read_curve_error(file + "#1"), file + ": has no zone 1, only " + file + "#0");
}

TEST_F(Files, CurvesAreValidated) {
  const std::string file = put("f", "0 0\n1 0\n0 0\n0 0\n");
  EXPECT_EQ(read_curve_error(file), file + ": has 2 distinct vertices, a closed curve needs three");
  EXPECT_EQ(read_curve(file, false).curve.points.size(), 4U);
}

TEST(Validate, CountsDistinctVertices) {
  const std::vector<Point> one{{1, 2}, {1, 2}};
  const std::vector<Point> zeros{{0.0, 0.0}, {-0.0, 0.0}, {1, 1}};
  const std::vector<Point> three{{0, 0}, {0, 0}, {1, 1}, {0, 0}, {1, 1}, {2, 2}};
  const auto error = [](const std::vector<Point>& points, bool closed) {
    return error_of([&] { validate({points, closed}, "c"); });
  };
  EXPECT_EQ(error({}, true), "c: has 0 distinct vertices, a closed curve needs three");
  EXPECT_EQ(error(one, false), "c: has 1 distinct vertex, an open curve needs two");
  EXPECT_EQ(error(zeros, true), "c: has 2 distinct vertices, a closed curve needs three");
  EXPECT_EQ(error(zeros, false), "no error");
  EXPECT_EQ(error(three, true), "no error");
}

TEST(Validate, NamesTheFirstVertexThatIsNotFinite) {
  std::vector<Point> points(300000, Point{1, 2});
  points[0] = {3, 4};
  points[5] = {3, 5};
  points[200000].x = -std::numeric_limits<double>::infinity();
  points[299999].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of([&] { validate({points, true}, "c"); }), "c: vertex 200000 is not finite");
}

TEST(DropClosingVertex, DropsEveryCopyOfTheFirst) {
  std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {0, 0}, {-0.0, 0}};
  drop_closing_vertex(points);
  EXPECT_EQ(points, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}));
  points.assign(3, Point{1, 1});
  drop_closing_vertex(points);
  EXPECT_EQ(points.size(), 1U);
  points.clear();
  drop_closing_vertex(points);
  EXPECT_TRUE(points.empty());
}

struct ExpectedForm {
  std::string_view name;
  std::size_t zones;
  std::size_t points_of_first;
  Point first;
};

TEST(RealData, ReadsWhatLober18Wrote) {
  const std::vector<ExpectedForm> all{
      {"run1/u.n", 1, 8056, {-1.049623606362420e-01, -1.000000000000000e-12}},
      {"run1/s.n", 1, 8056, {-1.049623606362420e-01, 1.000000000000000e-12}},
      {"run1/lobeb.dat", 20, 1202, {-0.105037786682682932060117764195, -0.000453034047444040178370672223}},
      {"run1/pips.dat", 1, 21, {-0.105037786682682932060117764195, -0.000453034047444040178370672223}},
      {"ovp5a/mani.dat", 2, 257, {1.455141999999999935511141302413, 0.009705999999999999350297485989}},
      {"ovp5a/lobeb.dat", 6, 30, {1.443718749524872446698964267853, 0.253556744025878688653108383733}},
  };
  for (const ExpectedForm& expected : all) {
    const auto path = shared_data(expected.name);
    if (!path) GTEST_SKIP() << "shared data " << expected.name << " is not here (set LOBER_SHARED)";
    const CurveFile file = read_curve_file(path->string());
    EXPECT_EQ(file.format, Format::tecplot);
    ASSERT_EQ(file.zones.size(), expected.zones) << expected.name;
    EXPECT_EQ(file.zones[0].points.size(), expected.points_of_first) << expected.name;
    EXPECT_EQ(file.zones[0].points[0], expected.first) << expected.name;
  }
}

}  // namespace
}  // namespace lober
