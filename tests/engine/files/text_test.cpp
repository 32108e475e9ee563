// Text and Tecplot files: every variant that occurs, every error with its line, chunks of every size.
#include <cmath>
#include <random>

#include "curve_testing.hpp"
#include "engine/files/tecplot.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

using test::read;
using test::read_error;

const std::vector<Point> text_points{{1, 2}, {3, 4}, {5, -6}};

struct Variant {
  std::string_view name;
  std::string_view text;
  Format format;
};

class TextVariant : public ::testing::TestWithParam<Variant> {};

TEST_P(TextVariant, GivesTheThreePointsInOneZone) {
  const CurveFile file = read(GetParam().text);
  EXPECT_EQ(file.format, GetParam().format);
  EXPECT_EQ(file.path, "in");
  ASSERT_EQ(file.zones.size(), 1U);
  EXPECT_EQ(file.zones[0].points, text_points);
}

TEST_P(TextVariant, DoesNotDependOnTheChunks) {
  for (std::size_t chunk = 1; chunk <= GetParam().text.size() + 1; ++chunk) {
    const CurveFile file = read(GetParam().text, chunk);
    EXPECT_EQ(file.format, GetParam().format) << "chunk size " << chunk;
    ASSERT_EQ(file.zones.size(), 1U) << "chunk size " << chunk;
    EXPECT_EQ(file.zones[0].points, text_points) << "chunk size " << chunk;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, TextVariant,
    ::testing::Values(Variant{"blanks", "1 2\n3 4\n5 -6\n", Format::text},
                      Variant{"no_final_newline", "1 2\n3 4\n5 -6", Format::text},
                      Variant{"tabs", "1\t2\n3\t4\n5\t-6\n", Format::text},
                      Variant{"indented", "  1   2  \n\t3\t 4\t\n 5 -6\n", Format::text},
                      Variant{"crlf", "1 2\r\n3 4\r\n5 -6\r\n", Format::text},
                      Variant{"crlf_without_final_newline", "1 2\r\n3 4\r\n5 -6\r", Format::text},
                      Variant{"comma", "1,2\n3,4\n5,-6\n", Format::text},
                      Variant{"comma_and_blanks", "1, 2\n3 ,4\n5 , -6\n", Format::text},
                      Variant{"semicolon", "1;2\n3;4\n5;-6\n", Format::text},
                      Variant{"csv_header", "x,y\n1,2\n3,4\n5,-6\n", Format::text},
                      Variant{"csv_quoted_header", "\"x\",\"y\"\n1,2\n3,4\n5,-6\n", Format::text},
                      Variant{"header_after_comment", "# made by hand\n\nx y\n1 2\n3 4\n5 -6\n", Format::text},
                      Variant{"header_like_a_keyword", "zone,title\n1,2\n3,4\n5,-6\n", Format::text},
                      Variant{"comments", "# x y\n1 2\n  # between\n3 4 # behind\n5 -6#\n", Format::text},
                      Variant{"blank_lines", "\n\n1 2\n \n3 4\n\t\r\n5 -6\n\n\n", Format::text},
                      Variant{"byte_order_mark",
                              "\xEF\xBB\xBF"
                              "1 2\n3 4\n5 -6\n",
                              Format::text},
                      Variant{"plus_signs", "+1 +2\n+3 4\n5 -6\n", Format::text},
                      Variant{"exponents", "1e0 2E0\n.3e1 4.\n5e+0 -600e-2\n", Format::text},
                      Variant{"fortran_exponents", "1D0 0.2d1\n.3D+1 4\n5 -600D-2\n", Format::text},
                      Variant{"thirty_digits",
                              "1.000000000000000000000000000000\t2.000000000000000000000000000000\n"
                              "3.000000000000000000000000000000\t4.000000000000000000000000000000\n"
                              "5.000000000000000000000000000000\t-6.000000000000000000000000000000\n",
                              Format::text},
                      Variant{"latin1_comment", "# d\xE9pos\xE9\n1 2\n3 4\n5 -6\n", Format::text},
                      Variant{"cyrillic_comment",
                              "# \xD0\xBB\xD0\xBE\xD0\xB1\xD0\xB5\xD1\x80 "
                              "\xD0\xBB\xD0\xBE\xD0\xB1\xD0\xB5\xD1\x80\n1 2\n3 4\n5 -6\n",
                              Format::text}));

INSTANTIATE_TEST_SUITE_P(
    Tecplot, TextVariant,
    ::testing::Values(
        Variant{"variables_only", "VARIABLES=\"x\"\"y\"\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"commas", "VARIABLES = \"x\", \"y\"\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"blanks_between", "variables = \"x\" \"y\"\nzone\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"doubled_single_quotes", "VARIABLES=''x''''y''\nZONE T=''a''\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"single_quotes", "Variables='x','y'\nZone T='a'\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"unquoted", "VARIABLES = x, y\nZONE T=a, I=3\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"names_on_the_next_lines", "VARIABLES =\n\"x\"\n\"y\"\nZONE\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"second_name_on_the_next_line", "VARIABLES = \"x\"\n\"y\"\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"title", "TITLE = \"a # b\"\nVARIABLES=\"x\"\"y\"\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"zone_only", "ZONE\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"all_attributes",
                "VARIABLES=\"x\"\"y\"\nZONE T=\"a\", I=3, J=1, K=1, F=POINT, C=RED, DT=(SINGLE SINGLE)\n1 "
                "2\n3 4\n5 -6\n",
                Format::tecplot},
        Variant{"zone_over_lines",
                "VARIABLES=\"x\"\"y\"\nZONE T=\"a\"\n I=3, J=1\n ZONETYPE=Ordered\n DATAPACKING=point\n1 "
                "2\n3 4\n5 -6\n",
                Format::tecplot},
        Variant{"n", "ZONE N = 3\n1 2\n3 4\n5 -6\n", Format::tecplot},
        Variant{"comment_in_header", "#c\nVARIABLES=\"x\"\"y\" # two\n# between\nZONE I=3 # three\n1 2\n3 4\n5 -6\n",
                Format::tecplot},
        Variant{"crlf", "VARIABLES=\"x\"\"y\"\r\nZONE T=\"a\"\r\n1\t2\r\n3\t4\r\n5\t-6", Format::tecplot},
        Variant{"auxiliary_data",
                "DATASETAUXDATA eps = \"0.1\"\nVARIABLES=\"x\"\"y\"\nZONE\nAUXDATA a=\"b\"\n1 2\n3 4\n5 -6\n",
                Format::tecplot},
        Variant{"byte_order_mark", "\xEF\xBB\xBFVARIABLES=\"x\"\"y\"\n1 2\n3 4\n5 -6\n", Format::tecplot}));

TEST(Tecplot, ReadsSeveralZonesWithTitlesAndLines) {
  const std::string_view text =
      "VARIABLES=\"x\"\"y\"\nZONE T=\"zone=0 lobe=0\"\n1 2\n3 4\n\nZONE I=1\n5 6\n# c\nZONE T=\"a \\\"b\\\" "
      "\\\\c\", N=3\n7 8\n9 "
      "10\n11 12\n";
  for (std::size_t chunk = 1; chunk <= text.size() + 1; ++chunk) {
    const CurveFile file = read(text, chunk);
    ASSERT_EQ(file.zones.size(), 3U) << "chunk size " << chunk;
    EXPECT_EQ(file.zones[0].title, "zone=0 lobe=0");
    EXPECT_EQ(file.zones[1].title, "");
    EXPECT_EQ(file.zones[2].title, "a \"b\" \\c");
    EXPECT_EQ(file.zones[0].line, 2U);
    EXPECT_EQ(file.zones[1].line, 6U);
    EXPECT_EQ(file.zones[2].line, 9U);
    EXPECT_EQ(file.zones[0].points, (std::vector<Point>{{1, 2}, {3, 4}}));
    EXPECT_EQ(file.zones[1].points, (std::vector<Point>{{5, 6}}));
    EXPECT_EQ(file.zones[2].points, (std::vector<Point>{{7, 8}, {9, 10}, {11, 12}}));
  }
}

TEST(Tecplot, PointsBeforeTheFirstZoneAreAZone) {
  const CurveFile file = read("1 2\n3 4\nZONE\n5 6\n");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[0].points.size(), 2U);
  EXPECT_EQ(file.zones[1].points.size(), 1U);
}

TEST(Tecplot, FilesPutOneBehindTheOtherAreNotOneCurve) {
  const CurveFile file = read("VARIABLES=\"x\"\"y\"\n1 2\n3 4\nVARIABLES=\"x\"\"y\"\n5 6\n");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[1].points, (std::vector<Point>{{5, 6}}));
  EXPECT_EQ(file.zones[1].line, 4U);
}

// Three variables: the first two where they are x and y, or those that are chosen.
TEST(Tecplot, VariablesAreChosen) {
  const std::string text =
      "TITLE=\"5 of 7\"\nVARIABLES = \"X\",\n \"Y\" \"u 10\"\nZONE I = 2 T=\"a\"\n1 2 3\n4,5,6\n\nZONE N=1\n7\t8\t9 # "
      "c\n";
  const auto zones = [&](const std::string& columns, std::size_t chunk) {
    std::vector<std::vector<Point>> all;
    for (Zone& zone : read_curve_bytes("in", test::bytes_of(text), chunk, columns).zones) all.push_back(zone.points);
    return all;
  };
  using Zones = std::vector<std::vector<Point>>;
  for (const std::size_t chunk : {std::size_t{1}, std::size_t{20}, default_chunk_size}) {
    EXPECT_EQ(zones("", chunk), (Zones{{{1, 2}, {4, 5}}, {{7, 8}}}));
    EXPECT_EQ(zones("u 10,y", chunk), (Zones{{{3, 2}, {6, 5}}, {{9, 8}}}));
    EXPECT_EQ(zones("3,1", chunk), (Zones{{{3, 1}, {6, 4}}, {{9, 7}}}));
  }
  const auto error = [&](const std::string& columns) {
    return test::error_of([&] { (void)read_curve_bytes("in", test::bytes_of(text), default_chunk_size, columns); });
  };
  EXPECT_EQ(error("x,z"), "in: has no column \"z\"; its columns are X, Y, u 10");
  EXPECT_EQ(error("x,y,by=3"), "in: zones part the curves of Tecplot files, not a column");
  EXPECT_EQ(test::error_of([] { (void)read_curve_bytes("in", test::bytes_of("ZONE\n1 2\n"), 9, "1,2"); }),
            "in: this Tecplot file has no VARIABLES record, whose names choose columns");
}

TEST(Tecplot, TitlesSurviveQuoting) {
  for (const std::string title :
       {"", "plain", "a \"b\" c", "back\\slash", "end\\", "''", "#1", "tab\there", "T=1, I=7"}) {
    std::string text = "ZONE T=" + tecplot_title(title) + " I=1\n1 2\n";
    EXPECT_EQ(read(text).zones[0].title, title);
  }
}

struct Mistake {
  std::string_view text;
  std::string_view message;
};

TEST(TextErrors, SayWhereAndWhat) {
  const std::vector<Mistake> mistakes{
      {"", "in: the file is empty"},
      {"\n\n", "in: no points"},
      {"# nothing\n", "in: no points"},
      {"x,y\n", "in: no points"},
      {"VARIABLES=\"x\"\"y\"\n", "in: no points"},
      {"1\n", "in:1: expected two columns, found 1"},
      {"1 2\n3\n", "in:2: expected two columns, found 1"},
      {"1 2\n\n3 4 5\n", "in:3: expected two columns, found 3"},
      {"1 2\r\n3 4 5\r\n", "in:2: expected two columns, found 3"},
      {"1,2,\n", "in:1: expected two columns, found 3"},
      {"1,\n", "in:1: expected two columns, found 1"},
      {",1\n", "in:1: expected two columns, found 1"},
      {"1,,2\n", "in:1: expected two columns, found 3"},
      {"1,5 2,5\n",
       "in:1: commas separate columns here, and decimals begin with a point; write the numbers with points, as sed "
       "'s/,/./g' does"},
      {"0,0 1,0 1,1\n",
       "in:1: this line has 3 pairs of numbers; each point needs a line of its own, as tr -s '[:blank:]' '\\n' makes "
       "it; decimals begin with a point"},
      {"x,y\n0,0\t1,0  1,1 0,1\n",
       "in:2: this line has 4 pairs of numbers; each point needs a line of its own, as tr -s '[:blank:]' '\\n' makes "
       "it; decimals begin with a point"},
      {"t x y\n0,0 1,0 1,1\n",
       "in:2: commas separate columns here, and decimals begin with a point; write the numbers with points, as sed "
       "'s/,/./g' does"},
      {"t x y\n1 2 3\n", "in:2: expected two columns, found 3: t, x, y; choose two by FILE:NAME,NAME"},
      {"1 2\nnan 4\n", "in:2: not a finite number: \"nan\""},
      {"nan 1\n1 2\n", "in:1: not a finite number: \"nan\""},
      {"1 2\n3 NaN\n", "in:2: not a finite number: \"NaN\""},
      {"1 2\n3 -inf\n", "in:2: not a finite number: \"-inf\""},
      {"1 2\n-Infinity 1\n", "in:2: not a finite number: \"-Infinity\""},
      {"1 2\n3 1e999\n", "in:2: not a finite number: \"1e999\""},
      {"1 2\n-1.8e308 1\n", "in:2: not a finite number: \"-1.8e308\""},
      {"1 2\nhello\n", "in:2: not a number: \"hello\""},
      {"hello\nworld\n", "in:2: not a number: \"world\""},
      {"x 1\n", "in:1: not a number: \"x\""},
      {"1 2\n3 4x\n", "in:2: not a number: \"4x\""},
      {"1 2\n3 0x10\n", "in:2: not a number: \"0x10\""},
      {"1 2\n3 +-4\n", "in:2: not a number: \"+-4\""},
      {"1 2\n3 1e\n", "in:2: not a number: \"1e\""},
      {"1 2\n. 3\n", "in:2: not a number: \".\""},
      {"1 2\n1.5-2\n", "in:2: not a number: \"1.5-2\""},
      {"1 2\n3 \x01\n", "in: neither text nor NPY, and 8 bytes are not a whole number of raw float64 pairs"},
      {"ZONE I=3\n1 2\n3 4\n", "in:1: I=3 is declared, found 2 points"},
      {"ZONE\nN=1\n1 2\n3 4\n", "in:2: N=1 is declared, found 2 points"},
      {"ZONE I=2\n1 2\nZONE I=2\n1 2\n3 4\n", "in:1: I=2 is declared, found 1 point"},
      {"ZONE I=-1\n1 2\n", "in:1: I=-1: expected a count"},
      {"ZONE I=99999999999999999999\n1 2\n", "in:1: I=99999999999999999999: expected a count"},
      {"ZONE I=1 J=2\n1 2\n", "in:1: J=2: expected one line of points, J=1"},
      {"ZONE F=BLOCK\n1 2\n", "in:1: F=BLOCK: not supported, write the zone as F=POINT"},
      {"ZONE\nDATAPACKING=BLOCK\n1 2\n", "in:2: DATAPACKING=BLOCK: not supported, write the zone as DATAPACKING=POINT"},
      {"ZONE ZONETYPE=FELINESEG\n1 2\n", "in:1: ZONETYPE=FELINESEG: not supported, expected ORDERED"},
      {"ZONE T=\"a\n1 2\n", "in:1: unterminated string: \"\"a\""},
      {"ZONE hello\n1 2\n", "in:1: expected KEY=VALUE in a ZONE record, found \"hello\""},
      {"VARIABLES=\"x\"\n1 2\n3 4\n", "in:1: expected two variables, found 1"},
      {"# c\nVARIABLES=\"x y\"\nZONE\n1 2\n", "in:2: expected two variables, found 1"},
      {"VARIABLES=\"t\",\"x\",\"y\"\n1 2 3\n", "in:1: expected two variables, found 3; choose two by FILE:NAME,NAME"},
      {"VARIABLES=\"t\"\n\"x\"\n\"y\"\n1 2 3\n", "in:3: expected two variables, found 3; choose two by FILE:NAME,NAME"},
      {"VARIABLES=\"x\",\"y\",\"z\"\nZONE\n1 2\n", "in:3: expected 3 columns, one for each variable, found 2"},
      {"ZONE T=\"a\"\nZONE T=\"b\"\n1 2\n", "in:1: the zone has no points"},
      {"ZONE T=\"a\"\n1 2\nZONE T=\"b\"\n", "in:3: the zone has no points"},
      {"VARIABLES=\"x\"\"y\"\nZONE\n1 2\nhello\n", "in:4: not a number: \"hello\""},
      {"1 2\n3 abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz\n",
       "in:2: not a number: \"abcdefghijklmnopqrstuvwxyzabcdefghijklmn...\""},
  };
  for (const Mistake& mistake : mistakes) {
    for (std::size_t chunk = 1; chunk <= mistake.text.size() + 1; ++chunk) {
      EXPECT_EQ(read_error(mistake.text, chunk), mistake.message) << mistake.text << "chunk size " << chunk;
    }
  }
}

TEST(TextErrors, TheFirstOneWins) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "1 2\n";
  const std::string good = text;
  for (int i = 0; i < 200; ++i) text += "1 2 3\n" + good.substr(0, 40);
  for (int repeat = 0; repeat < 20; ++repeat) {
    EXPECT_EQ(read_error(text, 64), "in:20001: expected two columns, found 3");
  }
}

TEST(TextChunks, LongFilesAreTheSameForEveryChunkSize) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  std::string text = "VARIABLES=\"x\"\"y\"\n";
  std::vector<std::vector<Point>> zones;
  for (const int points : {1, 1000, 3, 20000, 17}) {
    text += "# a comment\nZONE T=\"" + std::to_string(points) + "\", I=" + std::to_string(points) + "\n";
    zones.emplace_back();
    for (int i = 0; i < points; ++i) {
      const Point point{coordinate(random), std::ldexp(coordinate(random), -i % 1000)};
      zones.back().push_back(point);
      char line[80];
      const int size = std::snprintf(line, sizeof line, "%.17g %.17g\n", point.x, point.y);
      text.append(line, static_cast<std::size_t>(size));
    }
  }
  for (const std::size_t chunk : {1U, 7U, 64U, 1000U, 4096U, 65536U, 1U << 20, 1U << 30}) {
    const CurveFile file = read(text, chunk);
    ASSERT_EQ(file.zones.size(), zones.size());
    for (std::size_t k = 0; k < zones.size(); ++k) {
      EXPECT_TRUE(test::same_bits(file.zones[k].points, zones[k])) << "zone " << k << ", chunk size " << chunk;
    }
  }
}

}  // namespace
}  // namespace lober::detail
