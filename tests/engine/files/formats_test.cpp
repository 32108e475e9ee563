// Files of other programs: what numpy, scipy, h5py, netCDF4, geopandas wrote (tests/corpus/make_formats.py) is read,
// what lober writes is read back, and damaged files end in one line.
#include "lober/curve/formats.hpp"

#include <bit>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <sstream>

#include "engine/files/read_memory.hpp"
#include "formats_testing.hpp"

namespace lober::detail {
namespace {

using test::corpus;
using test::error_of;
using test::expect_points;
using test::first;
using test::moved;
using test::read_corpus;

std::string usage_error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Point> ring(std::vector<Point> points) {
  points.push_back(points.front());
  return points;
}

void expect_both(const CurveFile& file, Format format, double within = 0) {
  EXPECT_EQ(file.format, format);
  ASSERT_EQ(file.zones.size(), 2U) << file.path;
  expect_points(file.zones[0], first, within);
  expect_points(file.zones[1], moved(), within);
}

TEST(Formats, GzipIsUnpacked) {
  const CurveFile file = read_corpus("table.txt.gz");
  EXPECT_EQ(file.format, Format::text);
  expect_points(file.zones.at(0), first);
}

TEST(Formats, Npz) {
  REQUIRE_FORMAT(Format::npz);
  expect_both(read_corpus("two.npz"), Format::npz);
  expect_both(read_corpus("two.npz", "x,y"), Format::npz);
  expect_points(read_corpus("one.npz").zones.at(0), first, 1e-7);
  expect_points(read_corpus("one.npz", "half,half").zones.at(0), {{0, 0}, {1, 1}, {1.5, 1.5}, {0.1, 0.1}, {-0.3, -0.3}},
                3e-4);
  const CurveFile parts = read_corpus("parts.npz");
  expect_both(parts, Format::npz);
  EXPECT_EQ(parts.zones[0].title, "one");
  EXPECT_EQ(parts.zones[1].title, "zweite \xCF\x83");
  const CurveFile groups = read_corpus("parts.npz", "points,by=curve");
  expect_both(groups, Format::npz);
  EXPECT_EQ(groups.zones[0].title, "4");
}

TEST(Formats, Matlab) {
  REQUIRE_FORMAT(Format::mat);
  expect_points(read_corpus("v4.mat").zones.at(0), first);
  expect_both(read_corpus("v5.mat"), Format::mat);
  expect_points(read_corpus("v5.mat", "s.x,s.y").zones.at(0), first, 1e-7);
  expect_both(read_corpus("v73.mat"), Format::mat);
}

TEST(Formats, Hdf5) {
  REQUIRE_FORMAT(Format::hdf5);
  for (const char* columns : {"/orbit/inner/x,/orbit/inner/y", "orbit/inner/x,orbit/inner/y", "x,y"}) {
    expect_points(read_corpus("groups.h5", columns).zones.at(0), first, 1e-7);
  }
  expect_points(read_corpus("groups.h5", "xy").zones.at(0), moved(), 1e-15);
  expect_points(read_corpus("groups.h5").zones.at(0), moved(), 1e-15);  // the only array of points
  const CurveFile groups = read_corpus("groups.h5", "xy,by=id");
  ASSERT_EQ(groups.zones.size(), 2U);
  EXPECT_EQ(groups.zones[0].points.size(), 3U);
  EXPECT_EQ(groups.zones[1].points.size(), 2U);
}

TEST(Formats, NetCdf) {
  for (const char* name : {"classic.nc", "offset.nc", "data.nc", "four.nc"}) {
    const bool is_hdf5 = std::string(name) == "four.nc";
    REQUIRE_FORMAT(is_hdf5 ? Format::hdf5 : Format::netcdf);
    const CurveFile file = read_corpus(name);
    expect_both(file, is_hdf5 ? Format::hdf5 : Format::netcdf, 1e-15);
    EXPECT_EQ(latitude_first(file), false);
    expect_both(read_corpus(name, "lon,lat"), file.format, 1e-15);
  }
  // The axes of a grid are no curve.
  const std::string message = error_of([] { (void)read_corpus("grid.nc"); });
  EXPECT_NE(message.find("which arrays are x and y?"), std::string::npos) << message;
  EXPECT_EQ(read_corpus("grid.nc", "lon,lat").zones.at(0).points.size(), 5U);
}

TEST(Formats, GeoJson) {
  REQUIRE_FORMAT(Format::geojson);
  const CurveFile file = read_corpus("features.geojson");
  EXPECT_EQ(file.format, Format::geojson);
  ASSERT_EQ(file.zones.size(), 7U);
  expect_points(file.zones[0], ring(first));
  EXPECT_EQ(file.zones[0].title, "one");
  EXPECT_EQ(file.zones[1].title, "one, hole 1");
  EXPECT_FALSE(file.zones[0].hole);
  EXPECT_EQ(file.zones[1].points.size(), 4U);
  EXPECT_TRUE(file.zones[1].hole);
  expect_points(file.zones[2], ring(moved()));
  EXPECT_EQ(file.zones[2].title, "two");
  EXPECT_EQ(file.zones[4].hole, true);
  EXPECT_EQ(file.zones[5].hole, false);
  expect_points(file.zones[6], {{1, 2}, {3, 4.5}});  // points in a row are one curve
}

TEST(Formats, Shapefile) {
  REQUIRE_FORMAT(Format::shapefile);
  const CurveFile file = read_corpus("polygons.shp");
  ASSERT_EQ(file.zones.size(), 3U);
  EXPECT_EQ(file.zones[0].points.size(), 6U);
  EXPECT_TRUE(file.zones[1].hole);
  EXPECT_EQ(file.zones[2].title, "shape 1");
}

CurveFile read_text_file(const std::string& text, const std::string& columns = {}) {
  return read_curve_bytes("in", std::as_bytes(std::span(text)), default_chunk_size, columns);
}

TEST(Formats, WellKnownText) {
  const auto zones = [](const std::string& text) {
    const CurveFile file = read_text_file(text);
    EXPECT_EQ(file.format, Format::wkt) << text;
    return file.zones;
  };
  EXPECT_EQ(zones("POLYGON((0 0,1 0,1 1,0 0),(0.2 0.2,0.4 0.2,0.4 0.4,0.2 0.2))").at(1).hole, true);
  EXPECT_EQ(zones("# one\n\npolygon Z ((0 0 5, 1 0 5, 1 1 5, 0 0 5))\n").at(0).points.at(2).y, 1);
  EXPECT_EQ(zones("SRID=4326;LINESTRING (0 0, 1 1e-3)\nSRID=4326;LINESTRING(2 2, 3 3)").size(), 2U);
  EXPECT_EQ(zones("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 6 5, 6 6, 5 5), (5.5 5.2, 5.6 5.2, 5.6 5.3, 5.5 5.2)))")
                .size(),
            3U);
  EXPECT_EQ(zones("GEOMETRYCOLLECTION (POINT (1 2), LINESTRING EMPTY, MULTIPOINT ((1 1), (2 2)))").size(), 2U);
  EXPECT_EQ(zones("POLYGON EMPTY\nMULTIPOLYGON (EMPTY, ((0 0, 1 0, 1 1, 0 0)))\nPOLYGON Z EMPTY\n").size(), 1U);
  EXPECT_EQ(error_of([] { (void)read_text_file("POLYGON EMPTY"); }), "in: no points");
  EXPECT_EQ(zones("MULTIPOINT (1 1, 2 2, 3 3)").at(0).points.size(), 3U);
  EXPECT_EQ(zones("POINT (1 2)\nPOINT (3 4)\n").at(0).points.size(), 2U);
  // The header of a table.
  EXPECT_EQ(read_text_file("point line\n1 2\n3 4\n").format, Format::text);
  EXPECT_EQ(error_of([] { (void)read_text_file("POINT (1 2)\nPOLYGON ((0 0, 1 x, 1 1))"); }),
            "in:2: WKT: expected the numbers of a point before \"x, 1 1))\"");
  EXPECT_EQ(error_of([] { (void)read_text_file("LINESTRING (0 0, 1 1"); }), "in:1: WKT: expected ) before the end");
  EXPECT_EQ(error_of([] { (void)read_text_file("LINESTRING (0 0, 1)"); }),
            "in:1: WKT: expected the two numbers of a point before \")\"");
}

TEST(Formats, ChoicesOfColumnsAreForTablesAndArrays) {
  const std::string message = error_of([] { (void)read_text_file("POINT (1 2)", "x,y"); });
  EXPECT_EQ(message, "in: columns are chosen of tables, and arrays of NPZ, MAT, HDF5 and NetCDF files; this is wkt");
}

TEST(Formats, ArraysThatAreNotThereAreNamedWithThoseThatAre) {
  REQUIRE_FORMAT(Format::npz);
  EXPECT_EQ(error_of([] { (void)read_curve_file(corpus("two.npz"), {.columns = "u,y"}); }),
            corpus("two.npz") + ": has no array of numbers called \"u\"; it holds x (2 x 5), y (2 x 5)");
  EXPECT_EQ(error_of([] { (void)read_curve_file(corpus("one.npz"), {.columns = "xy,half"}); }),
            corpus("one.npz") + ": arrays xy (5 x 2) and half (5): expected equal shapes");
  EXPECT_EQ(error_of([] { (void)read_curve_file(corpus("one.npz"), {.columns = "half"}); }),
            corpus("one.npz") + ": array half (5): expected N x 2 or 2 x N numbers");
}

class WrittenFormats : public test::FolderTest {};

TEST_F(WrittenFormats, AreReadBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::vector<Zone> zones;
  for (int k = 0; k < 40; ++k) {
    Zone zone{"lobe " + std::to_string(k), {}, 1};
    zone.numbers = {{"area", 0.5 * k}};
    for (int i = 0; i < 5 + k; ++i)
      zone.points.push_back({std::bit_cast<double>((random() & 0x800fffffffffffffULL) | (random() % 2000 + 20) << 52),
                             std::uniform_real_distribution<double>(-1, 1)(random)});
    zone.points.push_back({-0.0, 3});
    zone.hole = k % 5 == 1;
    zones.push_back(zone);
  }
  for (const FormatInfo& format : formats()) {
    if (!format.writes || !format.missing.empty()) continue;
    for (const bool closed : {false, true}) {
      const std::string name = path("curves" + std::string(format.suffixes.substr(0, format.suffixes.find(' '))));
      const std::span<const Zone> written = format.takes_several ? zones : std::span(zones).first(1);
      write_curves(name, written, {.closed = closed, .provenance = {{"version", "0"}, {"input 1", "a \"b\" <c>"}}});
      if (!format.reads) continue;
      const CurveFile file = read_curve_file(name, {.columns = format.format == Format::csv ? "x,y,by=curve" : ""});
      ASSERT_EQ(file.zones.size(), written.size()) << name;
      const bool has_rings = closed && (format.format == Format::geojson || format.format == Format::wkt);
      for (std::size_t k = 0; k < written.size(); ++k) {
        std::vector<Point> points = file.zones[k].points;
        if (has_rings) {
          EXPECT_TRUE(points.front().x == points.back().x && points.front().y == points.back().y) << name;
          points.pop_back();
          EXPECT_EQ(file.zones[k].hole, written[k].hole) << name << ' ' << k;
        }
        EXPECT_TRUE(test::same_bits(points, written[k].points)) << name << ' ' << k;
      }
    }
  }
}

TEST_F(WrittenFormats, SameBytesEachTime) {
  const std::vector<Zone> zones{{"a", first}, {"b", moved()}};
  for (const FormatInfo& format : formats()) {
    if (!format.writes || !format.takes_several || !format.missing.empty()) continue;
    const auto written = [&](const std::string& name) {
      write_curves(path(name), zones, {.format = format.format, .closed = true});
      std::ostringstream text;
      text << std::ifstream(path(name), std::ios::binary).rdbuf();
      return text.str();
    };
    EXPECT_EQ(written("one"), written("two")) << format.name;
  }
}

TEST_F(WrittenFormats, TabsWhereTheEndingPromisesThem) {
  for (const auto& [name, line] : {std::pair{"a.tsv", "0\t0"}, {"a.TSV", "0\t0"}, {"a.txt", "0 0"}, {"tsv", "0 0"}}) {
    write_curves(path(name), std::vector<Zone>{{"", first}}, {.format = Format::text});
    EXPECT_TRUE(content(path(name)).starts_with(line)) << name << '\n' << content(path(name));
    expect_points(read_curve_file(path(name)).zones.at(0), first);
  }
}

// Each curve is what it says; the others are what the options say.
TEST_F(WrittenFormats, PolygonsAndLinesInOneFile) {
  std::vector<Zone> zones{{"ring", first}, {"line", moved()}, {"other", first}};
  zones[0].closed = true;
  zones[1].closed = false;
  for (std::size_t k = 0; k < zones.size(); ++k) zones[k].numbers = {{"energy", 1.0 * static_cast<double>(k)}};
  for (const bool closed : {false, true}) {
    const std::string other = closed ? "POLYGON" : "LINESTRING";
    write_curves(path("m.wkt"), zones, {.closed = closed});
    const std::string wkt = content(path("m.wkt"));
    EXPECT_TRUE(wkt.starts_with("POLYGON ((")) << wkt;
    EXPECT_NE(wkt.find("\nLINESTRING ("), std::string::npos) << wkt;
    EXPECT_NE(wkt.find("\n" + other + " (", wkt.find("LINESTRING") + 1), std::string::npos) << wkt;
    write_curves(path("m.geojson"), zones, {.closed = closed});
    const std::string json = content(path("m.geojson"));
    const auto count = [](const std::string& text, const std::string& word) {
      std::size_t found = 0;
      for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
      return found;
    };
    EXPECT_EQ(count(json, "\"Polygon\""), closed ? 2U : 1U) << json;
    EXPECT_EQ(count(json, "\"LineString\""), closed ? 1U : 2U) << json;
    write_curves(path("m.vtp"), zones, {.closed = closed});
    const std::string vtk = content(path("m.vtp"));
    EXPECT_NE(vtk.find(closed ? "NumberOfLines=\"1\"" : "NumberOfLines=\"2\""), std::string::npos) << vtk;
    EXPECT_NE(vtk.find(closed ? "NumberOfPolys=\"2\"" : "NumberOfPolys=\"1\""), std::string::npos) << vtk;
    // Data of cells: lines come first. "108" is the first letter of "line", "114" that of "ring".
    EXPECT_LT(vtk.find(">108 105 "), vtk.find("114 105 110 103 0 ")) << vtk;
    for (const char* const name : {"m.wkt", "m.geojson"}) {
      const CurveFile file = read_curve_file(path(name));
      ASSERT_EQ(file.zones.size(), 3U);
      EXPECT_EQ(file.zones[0].points.size(), first.size() + 1);
      EXPECT_EQ(file.zones[1].points.size(), first.size());
      EXPECT_EQ(file.zones[2].points.size(), first.size() + (closed ? 1 : 0));
    }
  }
}

TEST_F(WrittenFormats, CurvesWithoutPointsAreEmptyInWkt) {
  for (const bool closed : {false, true}) {
    write_curves(path("e.wkt"), std::vector<Zone>{{"a", {}}, {"b", first}}, {.closed = closed});
    EXPECT_TRUE(content(path("e.wkt")).starts_with(closed ? "POLYGON EMPTY\nPOLYGON ((0 0, " : "LINESTRING EMPTY\n"));
    EXPECT_EQ(read_curve_file(path("e.wkt")).zones.size(), 1U);
  }
}

// From the first positions; from above where the file is compressed.
TEST_F(WrittenFormats, PointsAreEstimated) {
  std::vector<Zone> zones;
  for (int k = 0; k < 300; ++k) zones.push_back({"", {}, 1});
  std::mt19937_64 random(2);
  for (Zone& zone : zones) {
    for (int k = 0; k < 100; ++k)
      zone.points.push_back({std::uniform_real_distribution<double>(-1, 1)(random), 1.0 * k});
  }
  for (const char* const name : {"e.txt", "e.geojson", "e.wkt", "e.npz"}) {
    if (const auto all = formats(); std::any_of(all.begin(), all.end(), [&](const FormatInfo& one) {
          return one.format == format_of_name(name) && !one.missing.empty();
        })) {
      std::cout << name << " is left out: its library is not there\n";
      continue;
    }
    write_curves(path(name), zones);
    EXPECT_NEAR(static_cast<double>(estimate_points(path(name))), 30000, 4000) << name;
  }
  EXPECT_GE(estimate_points(corpus("table.txt.gz")), 5U);
  EXPECT_LE(estimate_points(corpus("table.txt.gz")), 50U);
}

TEST_F(WrittenFormats, EndingsThatCannotBeWritten) {
  const std::vector<Zone> two{{"a", first}, {"b", moved()}};
  EXPECT_NE(usage_error_of([&] { write_curves(path("x.mat"), two); })
                .find("files of the format mat are only read; curves are "
                      "written as .npy, .csv, .txt, .dat (tecplot), .f64"),
            std::string::npos);
  EXPECT_NE(usage_error_of([&] {
              write_curves(path("x.npy"), two);
            }).find("several curves need another format than npy, which holds one; several are written as .csv, .txt"),
            std::string::npos);
  EXPECT_NE(usage_error_of([&] { write_curves(path("x"), two); }).find("the ending does not name a format"),
            std::string::npos);
}

// Every file of the corpus cut off anywhere, or with bytes that are not what was written: curves, or one line that
// begins with the name.
TEST(Formats, DamagedFilesEndInOneLine) {
  std::mt19937_64 random(3);
  std::size_t refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus(""))) {
    std::ostringstream content;
    content << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    const std::string whole = content.str();
    for (int k = 0; k < 60; ++k) {
      std::string bytes = whole;
      if (k % 2 == 0) {
        bytes.resize(1 + random() % (bytes.size() - 1));
      } else if (bytes.find("\x89HDF") != std::string::npos) {
        // The library of Debian 12 (1.10.8) frees memory twice while it lists the links of damaged groups.
        if (k == 1)
          std::cout << "left out: edits of " << entry.path().filename() << ", which HDF5 1.10.8 does not survive\n";
        continue;
      } else {
        for (int edits = 0; edits < 3; ++edits) bytes[random() % bytes.size()] = static_cast<char>(random() & 0xFF);
      }
      try {
        (void)read_curve_bytes("in", std::as_bytes(std::span(bytes)));
      } catch (const DataError& error) {
        ++refused;
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("in:")) << entry.path() << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << entry.path() << ": " << message;
      }
    }
  }
  EXPECT_GT(refused, 300U);
}

// Cut off anywhere, MAT files of version 5 are refused: matio would read what memory holds.
TEST(Formats, MatFilesThatAreCutOff) {
  REQUIRE_FORMAT(Format::mat);
  for (const char* name : {"v4.mat", "v5.mat"}) {
    std::ostringstream content;
    content << std::ifstream(corpus(name), std::ios::binary).rdbuf();
    const std::string whole = content.str();
    // Between two variables the end is as good as any.
    std::size_t refused = 0;
    for (std::size_t size = std::min<std::size_t>(130, whole.size()); size < whole.size(); ++size) {
      const std::string cut = whole.substr(0, size);
      try {
        const CurveFile file = read_curve_bytes("in", std::as_bytes(std::span(cut)), default_chunk_size, "x,y");
        EXPECT_EQ(file.zones.size(), 2U) << size;
        expect_points(file.zones[0], first);
      } catch (const DataError&) {
        ++refused;
      }
    }
    EXPECT_GE(refused + 8, whole.size() - std::min<std::size_t>(130, whole.size())) << name;
  }
}

// A file of a few bytes that promises more than any memory.
TEST(Formats, PromisesAreNotBelieved) {
  REQUIRE_FORMAT(Format::hdf5);
  const std::string classic = [] {
    std::ostringstream content;
    content << std::ifstream(corpus("classic.nc"), std::ios::binary).rdbuf();
    return content.str();
  }();
  std::string bytes = classic;
  const std::size_t at = bytes.find("obs") + 4;
  bytes.replace(at, 4, "\x7F\xFF\xFF\xFF");
  const std::string message =
      error_of([&] { (void)read_curve_bytes("in", std::as_bytes(std::span(bytes)), default_chunk_size, "lon,lat"); });
  EXPECT_TRUE(message.starts_with("in:")) << message;
}

}  // namespace
}  // namespace lober::detail
