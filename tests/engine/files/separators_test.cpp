// One separator a table: blanks, '#' and other separators inside of cells, quotes, empty cells, Excel's first line.
#include "curve_testing.hpp"
#include "engine/files/column_choice.hpp"
#include "engine/files/text_cells.hpp"

namespace lober::detail {
namespace {

CurveFile read_cells(const std::string& text, const std::string& columns = {},
                     std::size_t chunk_size = default_chunk_size) {
  return read_curve_bytes("in", test::bytes_of(text), chunk_size, columns);
}

// The same in chunks of every size.
void expect_points(const std::string& text, const std::string& columns, const std::vector<Point>& points) {
  for (std::size_t chunk = 1; chunk <= text.size() + 1; ++chunk) {
    try {
      const CurveFile file = read_cells(text, columns, chunk);
      ASSERT_EQ(file.zones.size(), 1U) << text << columns << " in chunks of " << chunk;
      EXPECT_EQ(file.zones[0].points, points) << text << columns << " in chunks of " << chunk;
    } catch (const DataError& error) {
      FAIL() << text << columns << " in chunks of " << chunk << ": " << error.what();
    }
  }
}
void expect_fault(const std::string& text, const std::string& columns, const std::string& message) {
  for (std::size_t chunk = 1; chunk <= text.size() + 1; ++chunk) {
    EXPECT_EQ(test::error_of([&] { (void)read_cells(text, columns, chunk); }), message) << text << columns;
  }
}

const std::vector<Point> three{{1, 2}, {3, 4}, {5, -6}};

// A comma parts the header and the line into two cells each, the first of which would go on behind its quotes.
TEST(Separators, OthersInsideOfQuotedCells) {
  expect_points(
      "\"\";\"x, m\";\"place\";\"y\"\n\"0\";\"1\";\"Lake, #1\";\"2\"\n\"1\";\"3\";\"a, "
      "b\";\"4\"\n\"2\";\"5\";\"\";\"-6\"\n",
      "\"x, m\",y", three);
}

TEST(Separators, BlanksInsideOfCells) {
  for (const char separator : {',', ';', '\t'}) {
    const auto with = [&](std::string text) {
      std::replace(text.begin(), text.end(), '|', separator);
      return text;
    };
    const std::string rows =
        "2020-01-01 00:00:00|1|Lake Como|2\n2020-01-01 01:00:00| 3 ||4\n2020-01-01 02:00:00|5|b  c |-6\n";
    expect_points(with("time|Lon (deg)|place|Lat (deg)\n" + rows), "Lon (deg),Lat (deg)", three);
    expect_points(with(rows), "2,4", three);
    expect_points(with("time|u 10|place|v 10\n" + rows), "u 10,v 10", three);
    expect_points(with("10 m u|10 m v|depth 5\n1|2|0\n3|4|0\n5|-6|0\n"), "10 m u,10 m v", three);
    expect_points(with("lon east|lat north|depth\n1|2|a b\n3|4|\n5|-6|c d e\n"), "", three);
  }
}

TEST(Separators, HeaderAndNumbersAgreeOnOne) {
  // Commas are text where the header has semicolons or tabs alone.
  expect_points("name;x;y\nParis, France;1;2\nRome;3;4\nBonn, Germany;5;-6\n", "x,y", three);
  expect_points("name\tx\ty\nParis, France\t1\t2\na;b\t3\t4\nBonn\t5\t-6\n", "x,y", three);
  // Without a header the first that parts the line.
  expect_points("a b;c,1,2\nd,3,4\ne f,5,-6\n", "2,3", three);
  // A header with other separators than the numbers, as it was always read.
  expect_points("x, y, z\n1 2 3\n3 4 5\n5 -6 7\n", "", three);
  expect_points("lon lat time\n1,2,2020-01-01 00:00\n3,4,\n5,-6,x\n", "lon,lat", three);
  expect_points("# t x y\n0,1,2\n0,3,4\n0,5,-6\n", "x,y", three);
  expect_points("# table of lake 5, 2020\n0;1;2\n0;3;4\n0;5;-6\n", "2,3", three);
}

TEST(Separators, TabsThatAlignColumns) {
  expect_points("1\t\t2\n3\t4\n5\t\t-6\n", "", three);
  expect_points("0\t\t1\t2\t\n10\t3\t4\t\n10\t\t5\t-6\n", "2,3", three);
  expect_points("t\t\tx\ty\n0\t\t1\t2\n10\t\t3\t4\n10\t\t5\t-6\n", "x,y", three);
  // An index without a name, as pandas writes it, and empty cells.
  expect_points("\tlon\tlat\n0\t1\t2\n1\t3\t4\n2\t5\t-6\n", "lon,lat", three);
  expect_points(",lon,lat\n0,1,2\n1,3,4\n2,5,-6\n", "lon,lat", three);
  expect_points("id\tlon\tlat\n\t1\t2\na\t3\t4\n\t5\t-6\n", "lon,lat", three);
}

TEST(Separators, Quotes) {
  expect_points("\"1\",\"2\"\n\"3\",\"4\"\n\"5\",\"-6\"\n", "", three);
  expect_points("\"x\",\"y\"\n\"1\",\"2\"\n\"3\" , \"4\"\n\"5\";\" -6 \"\n", "", three);
  expect_points("\"n\",\"x\",\"y\"\n\"a, \"\"b\"\"\",\"1\",\"2\"\n\"#\",\"3\",\"4\"\n,\"5\",\"-6\"\n", "x,y", three);
  expect_points("\"1\"\t\"2\"\n3 4\n\"5\" -6\n", "", three);
  const CurveFile groups = read_cells("id,x,y\n\"a \"\"1\"\"\",1,2\nb,3,4\n\"b\",5,6\n", "x,y,by=id");
  ASSERT_EQ(groups.zones.size(), 2U);
  EXPECT_EQ(groups.zones[0].title, "a \"1\"");
  EXPECT_EQ(groups.zones[1].points.size(), 2U);
  const CurveFile gap = read_cells("\"1\",\"2\"\n\"NaN\",\"NaN\"\n\"3\",\"4\"\n");
  EXPECT_EQ(gap.zones.size(), 2U);
  expect_fault("n,x,y\n\"a\nb\",1,2\n", "x,y", "in:2: quotes do not end on their line: \"\"a\"");
  expect_fault("n,x,y\n\"a\",1,2\n\"a,3,4\n", "x,y", "in:3: quotes do not end on their line: \"\"a,3,4\"");
  expect_fault("\"1\",\"x\"\n", "", "in:1: not a number: \"x\"");
  // Names of variables, not numbers.
  EXPECT_EQ(test::read("VARIABLES =\n\"1\" \"2\"\n1 2\n3 4\n").zones.at(0).points.size(), 2U);
}

TEST(Separators, NumberSignsInCells) {
  expect_points("name,x,y\nLake #1,1,2\n#2 is a comment,9,9\n  # and, this\nLake#3,3,4\na # b,5,-6\n", "x,y", three);
  expect_points("Lake #1,1,2\nLake #2,3,4\nLake #3,5,-6\n", "2,3", three);
  expect_points("n,x,y\n0,1,2 # one\n0,3,4 # two, three\n0,5,-6\t#\n", "x,y", three);
  expect_points("0\t1\t2\t# one\n0\t3\t4 # two\n0\t5\t-6\n", "2,3", three);
  expect_points("1 2 # a, b\n3 4# c\n5 -6#\n", "", three);
  expect_points("0 1 2 # a, b\n0 3 4# c\n0 5 -6#\n", "2,3", three);
  const CurveFile file = read_cells("x,y,name\n1,2,Lake #1\n3,4,Lake #2\n5,6,Lake #1\n", "x,y,by=name");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[0].title, "Lake #1");
}

TEST(Separators, FirstLineOfExcel) {
  for (const std::string end : {"\n", "\r\n"}) {
    expect_points("sep=;" + end + "t;x;y" + end + "a, b;1;2" + end + ";3;4" + end + "c;5;-6" + end, "x,y", three);
    expect_points("sep=," + end + "1,2" + end + "3,4" + end + "5,-6" + end, "", three);
    expect_points("\xEF\xBB\xBFsep=\t" + end + "a\tx\ty" + end + "\t1\t2" + end + "\t3\t4" + end + "b c\t5\t-6" + end,
                  "x,y", three);
  }
  expect_fault("sep=|\n1|2\n", "", "in:1: the separator \"|\" is not known; it is a comma, a semicolon or a tab");
  expect_fault("sep=;\nx;y\n1;a\n", "", "in:3: not a number: \"a\"");
  expect_fault("sep=;\nx;y\n1,5;2,5\n", "",
               "in:3: commas separate columns here, and decimals begin with a point; write the numbers with points, as "
               "sed 's/,/./g' does");
  EXPECT_EQ(read_cells("sep=;\n1;2\n3;4\n").zones[0].line, 2U);
}

TEST(Separators, CommasOfAHeaderAreNotThoseOfDecimals) {
  expect_points("date time,x,y\n20200101 1200,1,2\n20200101 1300,3,4\n20200101 1400,5,-6\n", "x,y", three);
}

TEST(Separators, NamesWithCommas) {
  expect_points("\"x, m\",\"y, m\",z\n1,2,0\n3,4,0\n5,-6,0\n", "\"x, m\",\"y, m\"", three);
  expect_points("id,\"x, m\",y\n7,1,2\n7,3,4\n7,5,-6\n", " \"x, m\" , y , by = id", three);
  const std::vector<ChoicePart> parts = parts_of_choice("a,\"b,c\",by=\"d,\"\"e\"");
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].name, "b,c");
  EXPECT_EQ(parts[2].key, "by");
  EXPECT_EQ(parts[2].name, "d,\"e");
}

// ERDDAP's line of units, R's names of rows.
TEST(Separators, UnitsAndNamesOfRows) {
  expect_points("time,lon,lat\nUTC,degrees_east,degrees_north\n2020-01-01T00:00:00Z,1,2\n,3,4\n,5,-6\n", "lon,lat",
                three);
  expect_points("x\ty\tz\nm\tm\tm\n1\t2\t0\n3\t4\t0\n5\t-6\t0\n", "", three);
  expect_points("\"x\" \"y\"\n\"1\" 1 2\n\"2\" 3 4\n\"3\" 5 -6\n", "x,y", three);
  expect_fault("\"x\" \"y\"\n\"1\" 1 2\n", "",
               "in:2: expected two columns, found 3: x, y; choose two by FILE:NAME,NAME");
  expect_fault("t,x,y\na,b,c\nd,e,f\n0,1,2\n", "x,y", "in: no points");
}

TEST(Separators, TitlesAreNotPoints) {
  const CurveFile file = read_cells("> 1 2\n1 2 3\n4 5 6\n> 3 4\n7 8 9\n", "2,3");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.zones[1].title, "3 4");
}

}  // namespace
}  // namespace lober::detail
