// Tables of text: which columns are read, and where one curve ends and the next begins.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/files/curve_spec.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/files/curve_testing.hpp"

namespace lober::detail {
namespace {

std::string table_path(const std::string& name) {
  return (std::filesystem::temp_directory_path() / ("lober_tables_" + name)).string();
}
std::string put_table(const std::string& name, const std::string& text) {
  std::ofstream(table_path(name)) << text;
  return table_path(name);
}

CurveFile read_table(const std::string& text, const std::string& columns = {},
                     std::size_t chunk_size = default_chunk_size) {
  return read_curve_bytes("in", std::as_bytes(std::span(text)), chunk_size, columns);
}
std::string table_fault(const std::string& text, const std::string& columns = {}) {
  try {
    (void)read_table(text, columns);
  } catch (const DataError& error) {
    return error.what();
  }
  return "read";
}

using TablePoints = std::vector<Point>;
std::vector<TablePoints> curves_of_table(const CurveFile& file) {
  std::vector<TablePoints> all;
  for (const Zone& zone : file.zones) all.push_back(zone.points);
  return all;
}
std::vector<std::string> titles_of_table(const CurveFile& file) {
  std::vector<std::string> all;
  for (const Zone& zone : file.zones) all.push_back(zone.title);
  return all;
}

const std::string drifter_table =
    "id,time,lon,lat,depth\n"
    "a,0,1,10,5\n"
    "b,0,2,20,5\n"
    "a,1,3,30,6\n"
    "b,1,4,40,6\n"
    "a,2,5,50,7\n";

TEST(Tables, ColumnsByNameAndNumber) {
  const TablePoints all{{1, 10}, {2, 20}, {3, 30}, {4, 40}, {5, 50}};
  for (const char* const choice : {"lon,lat", "LON,Lat", "3,4", " 3 , lat "}) {
    EXPECT_EQ(curves_of_table(read_table(drifter_table, choice)), std::vector<TablePoints>{all}) << choice;
  }
  EXPECT_EQ(read_table(drifter_table, "lon,lat").header, "lon,lat");
  EXPECT_EQ(curves_of_table(read_table(drifter_table, "lat,time")),
            (std::vector<TablePoints>{{{10, 0}, {20, 0}, {30, 1}, {40, 1}, {50, 2}}}));
  // Blanks, tabs and quotes; names in a comment; no names.
  EXPECT_EQ(curves_of_table(read_table("\"the x\"\t\"the y\"\tz\n1\t2\t3\n4\t5\t6\n", "the x,z")),
            (std::vector<TablePoints>{{{1, 3}, {4, 6}}}));
  EXPECT_EQ(curves_of_table(read_table("# t x y\n0 1 2\n1 3 4\n", "x,y")),
            (std::vector<TablePoints>{{{1, 2}, {3, 4}}}));
  EXPECT_EQ(curves_of_table(read_table("0 1 2\r\n1 3 4\r\n", "2,3")), (std::vector<TablePoints>{{{1, 2}, {3, 4}}}));
  EXPECT_EQ(curves_of_table(read_table("name,x,y\n\"one, two\",1,2\nthree,3,4\n", "x,y")),
            (std::vector<TablePoints>{{{1, 2}, {3, 4}}}));
  EXPECT_EQ(curves_of_table(read_table("1 2\n3 4\n", "2,1")), (std::vector<TablePoints>{{{2, 1}, {4, 3}}}));
}

TEST(Tables, FirstTwoByTheirNames) {
  for (const char* const names : {"x,y,z", "X,Y,t", "lon,lat,depth", "longitude,latitude,time"}) {
    EXPECT_EQ(curves_of_table(read_table(std::string(names) + "\n1,2,9\n3,4,9\n")),
              (std::vector<TablePoints>{{{1, 2}, {3, 4}}}))
        << names;
  }
  EXPECT_EQ(table_fault("t,x,y\n0,1,2\n"),
            "in:2: expected two columns, found 3: t, x, y; choose two by FILE:NAME,NAME");
  EXPECT_EQ(table_fault("lat,lon,depth\n0,1,2\n"),
            "in:2: expected two columns, found 3: lat, lon, depth; choose two by FILE:NAME,NAME");
  EXPECT_EQ(table_fault("\n0 1 2\n"), "in:2: expected two columns, found 3; choose two by FILE:NUMBER,NUMBER");
}

TEST(Tables, WrongChoicesSayWhatThereIs) {
  EXPECT_EQ(table_fault(drifter_table, "lon,lot"),
            "in: has no column \"lot\"; its columns are id, time, lon, lat, depth");
  EXPECT_EQ(table_fault("1 2 3\n", "2,4"), "in: has no column \"4\"; it has 3 columns without names");
  EXPECT_EQ(table_fault("1 2 3\n", "0,1"), "in: has no column \"0\"; it has 3 columns without names");
  EXPECT_EQ(table_fault(drifter_table, "lon"),
            "in: two columns are chosen by \"NAME,NAME\" or \"NUMBER,NUMBER\", not by \"lon\"");
  EXPECT_EQ(table_fault(drifter_table, "lon,lat,depth"),
            "in: two columns are chosen by \"NAME,NAME\" or \"NUMBER,NUMBER\", not by \"lon,lat,depth\"");
  EXPECT_EQ(table_fault(drifter_table, "id,lat"), "in:2: not a number: \"a\"");
  EXPECT_EQ(table_fault("t,x,y\n0,1,2\n0,1\n", "x,y"), "in:3: expected 3 columns, as in the first line, found 2");
  EXPECT_EQ(table_fault("t,x,y\n0,1,2\n0,inf,2\n", "x,y"), "in:3: not a finite number: \"inf\"");
  EXPECT_EQ(table_fault("VARIABLES = \"x\" \"y\"\n1 2\n", "1,2"), "read");
  EXPECT_EQ(table_fault("x,y\n", "x,y"), "in: no points");
}

TEST(Tables, CurvesByGroup) {
  const CurveFile file = read_table(drifter_table, "lon,lat,by=id");
  EXPECT_EQ(titles_of_table(file), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(curves_of_table(file), (std::vector<TablePoints>{{{1, 10}, {3, 30}, {5, 50}}, {{2, 20}, {4, 40}}}));
}

TEST(Tables, GroupsOfATableOfTwoColumns) {
  const CurveFile file = read_table("1 7\n2 8\n3 7\n", "1,2,by=2");
  EXPECT_EQ(titles_of_table(file), (std::vector<std::string>{"7", "8"}));
  EXPECT_EQ(curves_of_table(file), (std::vector<TablePoints>{{{1, 7}, {3, 7}}, {{2, 8}}}));
}

TEST(Tables, CurvesByGapsBlankLinesAndMarks) {
  const std::vector<TablePoints> two{{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}, {9, 10}}};
  for (const char* const gap : {"nan nan", "NaN NaN", "-nan nan", "NAN,NAN", "", "\n\n", "\r\n", ">", "> b",
                                "# c\n\n# d", ",", ";", " , ", ",\r", "\"\",\"\"", "\"\" \"\"", ", # c"}) {
    for (const char* const end : {"", "\n", "\n\n\n", "\nnan nan\n", "\n>\n"}) {
      const std::string text = "1 2\n3 4\n" + std::string(gap) + "\n5 6\n7 8\n9 10" + end;
      for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, default_chunk_size}) {
        EXPECT_EQ(curves_of_table(read_table(text, {}, chunk)), two) << text << " in chunks of " << chunk;
      }
    }
  }
  const CurveFile marked = read_table("> first one \n1 2\n3 4\n>\n> second\n5 6\n7 8\n9 10\n");
  EXPECT_EQ(curves_of_table(marked), two);
  EXPECT_EQ(titles_of_table(marked), (std::vector<std::string>{"first one", "second"}));
  EXPECT_EQ(marked.zones[1].line, 6U);
  // Tables one behind the other, with their headers; wide ones, whose gaps may be empty fields.
  EXPECT_EQ(curves_of_table(read_table("x,y\n1,2\n3,4\n\nx,y\n5,6\n7,8\n9,10\n")), two);
  EXPECT_EQ(curves_of_table(read_table("t,x,y\n0,1,2\n0,3,4\n0,,\n0,5,6\n0,7,8\n0,9,10\n", "x,y")), two);
  EXPECT_EQ(curves_of_table(read_table("t,x,y\n0,1,2\n0,3,4\n0,nan,nan\n0,5,6\n0,7,8\n0,9,10\n", "x,y")), two);
  EXPECT_EQ(curves_of_table(read_table("x,y\n1,2\n3,4\n,\n5,6\n7,8\n9,10\n")), two);
  // So do rows of empty cells before the first point.
  EXPECT_EQ(curves_of_table(read_table("x,y\n,\n,\n1,2\n3,4\n,\n,\n5,6\n7,8\n9,10\n,\n")), two);
  EXPECT_EQ(curves_of_table(read_table("t,x,y\n,,\n,,\n0,1,2\n0,3,4\n,,\n0,5,6\n0,7,8\n0,9,10\n", "x,y")), two);
  // A blank line behind each point, at the beginning or before the end parts nothing.
  const std::vector<TablePoints> one{{{1, 2}, {3, 4}, {5, 6}}};
  EXPECT_EQ(curves_of_table(read_table("1 2\n\n3 4\n\n5 6\n\n")), one);
  EXPECT_EQ(curves_of_table(read_table("\n\n1 2\n3 4\n5 6\n\n\n")), one);
  EXPECT_EQ(curves_of_table(read_table("x y\n\n1 2\n3 4\n5 6\n")), one);
  EXPECT_EQ(curves_of_table(read_table("TITLE = \"t\"\n1 2\n\n3 4\n\n5 6\n")), one);
  // A single NaN is a fault.
  EXPECT_EQ(table_fault("1 2\n3 nan\n"), "in:2: not a finite number: \"nan\"");
  EXPECT_NE(table_fault("1 2\nnan 3\n"), "read");
  EXPECT_NE(table_fault("TITLE = \"t\"\n1 2\nnan nan\n3 4\n"), "read");
  EXPECT_NE(table_fault("TITLE = \"t\"\n1 2\n,\n3 4\n"), "read");
  // So is a single empty cell.
  EXPECT_EQ(table_fault("x,y\n1,2\n,3\n"), "in:3: expected two columns, found 1");
  EXPECT_EQ(table_fault("x,y\n1,2\n,,\n"), "in:3: expected two columns, found 3");
}

TEST(Tables, NamesOfCurves) {
  const std::string file = put_table("drifters.csv", drifter_table), colon = put_table("a:b", "1 2\n3 4\n5 7\n");
  const CurveSpec whole = split_spec(file + ":lon,lat,by=id#b");
  EXPECT_EQ(whole.file, file);
  EXPECT_EQ(whole.columns, "lon,lat,by=id");
  EXPECT_EQ(whole.zone, "b");
  EXPECT_EQ(split_spec(colon).file, colon);
  EXPECT_EQ(split_spec(colon + ":2,1").file, colon);
  EXPECT_EQ(split_spec("no such:1,2").file, "no such:1,2");
  EXPECT_EQ(file_of_curve(file + ":1,2"), file);
  EXPECT_EQ(read_curve(file + ":lon,lat,by=id#b", false).curve.points, (TablePoints{{2, 20}, {4, 40}}));
  EXPECT_EQ(read_curve(file, false, {.columns = "lon,lat"}).curve.points.size(), 5U);
  EXPECT_THROW((void)read_curve(file + ":lon,lat", false, {.columns = "lon,lat"}), UsageError);
  try {
    (void)read_curve(file + ":lon,lat,by=id", false);
    ADD_FAILURE() << "two zones, none chosen";
  } catch (const DataError& error) {
    EXPECT_EQ(std::string(error.what()), file + ": has 2 zones; choose one with " + file + ":lon,lat,by=id#0 to " +
                                             file + ":lon,lat,by=id#1, or by its title: \"a\", \"b\"");
  }
  std::filesystem::remove(file);
  std::filesystem::remove(colon);
}

// "1,5" for 1.5: no choice of columns may read that as 1 and 5.
TEST(Tables, DecimalCommasAreRefused) {
  for (const char* table : {"1,5 2,5\n3,5 4,5\n", "1,5;2,5\n", "1,5;2,5;3\n", "x y\n1,5\t2,5\n", "0,1   7\n"}) {
    for (const char* columns : {"", "1,2", "2,1"}) {
      EXPECT_NE(table_fault(table, columns).find("decimals begin with a point"), std::string::npos)
          << table << ' ' << columns;
    }
  }
  for (const char* table : {"1, 2\n3, 4\n", "1 ,2\n3 , 4\n", " 1,2 \n3,4\t\n", "1,2 # a b\n3,4\n"}) {
    EXPECT_EQ(read_table(table).zones.at(0).points, (TablePoints{{1, 2}, {3, 4}})) << table;
  }
}

// A Tecplot record below a table's rows would begin a zone in which a group's points end or not, by where chunks end.
TEST(Tables, RecordsAreFaultsInTables) {
  const std::string text = "1,2,a\n3,4,a\nzone t=0\n5,6,a\n";
  for (const char* columns : {"1,2,by=3", "1,2", "2,1"}) {
    for (const std::size_t chunk : {std::size_t{1}, std::size_t{12}, default_chunk_size}) {
      try {
        (void)read_table(text, columns, chunk);
        ADD_FAILURE() << columns << " in chunks of " << chunk;
      } catch (const DataError& error) {
        EXPECT_EQ(std::string(error.what()), "in:3: columns are chosen of tables, not of Tecplot files: \"zone t=0\"");
      }
    }
  }
}

// A number behind '#' is that of a group where all groups are numbers: drifter 7, not the eighth.
TEST(Tables, GroupsAreChosenByTheirNumbers) {
  const std::string ids = put_table("ids.csv", "id,lon,lat\n3,0,0\n1,1,1\n3,3,3\n1,2,2\n7,7,7\n");
  const std::string of = ids + ":lon,lat,by=id";
  EXPECT_EQ(read_curve(of + "#3", false).curve.points, (TablePoints{{0, 0}, {3, 3}}));
  EXPECT_EQ(read_curve(of + "#1", false).curve.points, (TablePoints{{1, 1}, {2, 2}}));
  for (const char* missing : {"#0", "#2"}) EXPECT_THROW((void)read_curve(of + missing, false), DataError) << missing;
  std::filesystem::remove(ids);
  // Several curves as lober writes them.
  const CurveFile curves = read_table("x,y,curve\n0,0,0\n1,1,0\n5,5,1\n6,6,1\n");
  ASSERT_EQ(curves.zones.size(), 2U);
  EXPECT_EQ(curves.zones[1].points, (TablePoints{{5, 5}, {6, 6}}));
  // Blanks inside of cells are no reason to take commas for those of decimals.
  EXPECT_EQ(table_fault("time,lon,lat\n2020-01-01 00:00:00,1,2\n", "lon,lat").find("decimals"), std::string::npos);
}

}  // namespace
}  // namespace lober::detail
