// Files of named arrays: attributes that say what numbers mean, curves of different lengths, complex numbers, lists.
#include "formats_testing.hpp"

namespace lober::detail {
namespace {

using test::expect_points;
using test::read_corpus;

std::vector<std::string> titles_of(const CurveFile& file) {
  std::vector<std::string> all;
  for (const Zone& zone : file.zones) all.push_back(zone.title);
  return all;
}

// Each in NetCDF's classic format and in that of HDF5.
template <typename Check>
void in_both_forms(const std::string& name, const Check& check) {
  for (const char* const form : {".nc", "4.nc"}) {
    REQUIRE_FORMAT(form[0] == '4' ? Format::hdf5 : Format::netcdf);
    check(name + form);
  }
}

TEST(ArrayFiles, PackedNumbersAndThoseThatStandForNone) {
  in_both_forms("packed", [](const std::string& name) {
    const CurveFile file = read_corpus(name);
    ASSERT_EQ(file.zones.size(), 2U) << name;
    expect_points(file.zones[0], {{0, 0}, {1, 0.5}, {1.5, 1}, {3250, 2}, {2000, 3}});
    expect_points(file.zones[1], {{0, 1}, {1, 1.5}, {1.5, 2}, {3250, 3}});
    EXPECT_EQ(latitude_first(file), false);
    EXPECT_EQ(read_corpus(name, "lon,LAT").zones.size(), 2U);
  });
  in_both_forms("unwritten", [](const std::string& name) {
    const CurveFile file = read_corpus(name);
    ASSERT_EQ(file.zones.size(), 1U) << name;
    expect_points(file.zones[0], {{1, 1}, {2, 2}, {4, 4}});
  });
}

TEST(ArrayFiles, CurvesOfDifferentLengths) {
  in_both_forms("ragged", [](const std::string& name) {
    for (const char* const choice :
         {"", "LONGITUDE,LATITUDE", "longitude,latitude", "LONGITUDE,LATITUDE,counts=rowsize"}) {
      const CurveFile file = read_corpus(name, choice);
      ASSERT_EQ(file.zones.size(), 2U) << name << choice;
      expect_points(file.zones[0], test::first);
      expect_points(file.zones[1], test::moved());
      EXPECT_EQ(titles_of(file), (std::vector<std::string>{"101", "2002"}));
    }
    EXPECT_EQ(read_curve(test::corpus(name) + "#2002", false).curve.points, test::moved());
    EXPECT_EQ(test::error_of([&] { (void)read_corpus(name, "LONGITUDE,LATITUDE,counts=ID"); }),
              test::corpus(name) + ": array " + (name == "ragged.nc" ? "" : "/") +
                  "ID (3): expected numbers of points whose sum is 10");
  });
  in_both_forms("indexed", [](const std::string& name) {
    const CurveFile file = read_corpus(name);
    ASSERT_EQ(file.zones.size(), 2U) << name;
    expect_points(file.zones[0], test::first);
    expect_points(file.zones[1], test::moved());
    EXPECT_EQ(titles_of(file), (std::vector<std::string>{"Como 2", "Bonn"}));
  });
}

TEST(ArrayFiles, EmptyCurvesKeepTheNumbersOfOthers) {
  REQUIRE_FORMAT(Format::npz);
  const CurveFile file = read_corpus("empty.npz");
  EXPECT_EQ(titles_of(file), (std::vector<std::string>{"1", "3"}));
  EXPECT_EQ(read_curve(test::corpus("empty.npz") + "#3", false).curve.points, test::moved());
  EXPECT_THROW((void)read_curve(test::corpus("empty.npz") + "#0", false), DataError);
}

// The two curves, the second with another point where `longer`.
void expect_two(const std::string& name, const std::string& choice, bool longer = false) {
  const CurveFile file = read_corpus(name, choice);
  ASSERT_EQ(file.zones.size(), 2U) << name << ' ' << choice;
  std::vector<Point> second = test::moved();
  if (longer) second.push_back({9, 8});
  expect_points(file.zones[0], test::first);
  expect_points(file.zones[1], second);
}

TEST(ArrayFiles, ListsOfMatlab) {
  REQUIRE_FORMAT(Format::mat);
  REQUIRE_FORMAT(Format::hdf5);
  expect_two("lists.mat", "s.x,s.y", true);
  expect_two("octave7.mat", "s.x,s.y", true);
  expect_two("lists73.mat", "s.x,s.y");
  for (const char* const name : {"lists.mat", "lists73.mat"}) {
    expect_two(name, "c");
    EXPECT_EQ(titles_of(read_corpus(name, "c")), (std::vector<std::string>{"0", "2"}));  // the cell between is empty
  }
  expect_two("octave7.mat", "c");
  expect_two("octave7.mat", "zz");
  expect_two("octave7.mat", "one.x,one.y");
  EXPECT_EQ(test::error_of([] { (void)read_corpus("lists.mat", "s.name,s.x"); }),
            test::corpus("lists.mat") +
                ": has no array of numbers called \"s.name\"; it holds c (10 x 2 in 3 pieces), "
                "s.x (11 in 2 pieces), s.y (11 in 2 pieces), z (1 x 5, complex), w (5 x 2, "
                "complex)");
}

// A compressed list that is damaged: matio made room for hundreds of millions of elements to list it.
TEST(ArrayFiles, ListsWithFalseLengthsAreRefused) {
  EXPECT_EQ(test::error_of([] { (void)read_corpus("damaged_list.mat"); }),
            test::corpus("damaged_list.mat") + ": is a MAT file that is damaged or cut off at byte 128");
}

TEST(ArrayFiles, ComplexNumbers) {
  REQUIRE_FORMAT(Format::npz);
  REQUIRE_FORMAT(Format::mat);
  REQUIRE_FORMAT(Format::hdf5);
  for (const char* const name : {"complex.npz", "lists.mat", "lists73.mat", "links.h5"}) {
    const CurveFile file = read_corpus(name, "z");
    ASSERT_EQ(file.zones.size(), 1U) << name;
    expect_points(file.zones[0], test::first);
  }
  expect_two("lists.mat", "w");
  const CurveFile both = read_corpus("complex.npz", "both");
  ASSERT_EQ(both.zones.size(), 2U);
  expect_points(both.zones[1], test::moved(), 1e-6);
  EXPECT_NE(test::error_of([] { (void)read_corpus("lists.mat", "z,w"); }).find("complex numbers are points"),
            std::string::npos);
}

TEST(ArrayFiles, LinksAndNames) {
  REQUIRE_FORMAT(Format::hdf5);
  for (const char* const choice : {"", "x,y", "/run/7/x,/run/7/y", "/last/x,last/y"}) {
    const CurveFile file = read_corpus("links.h5", choice);
    ASSERT_EQ(file.zones.size(), 1U) << choice;
    expect_points(file.zones[0], test::first);
  }
  for (const char* const choice : {":\"a#1\",\"b,1\"", ":\"/a#1\",\"/b,1\"#0"}) {
    EXPECT_EQ(read_curve(test::corpus("links.h5") + choice, false).curve.points, test::moved()) << choice;
  }
}

}  // namespace
}  // namespace lober::detail
