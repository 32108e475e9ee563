// Curves of longitudes and latitudes, which are read as points of the plane: what is said of them.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "curve_testing.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober {
namespace {

class Geographic : public test::FolderTest {
 protected:
  // A circle of 20 degrees about a longitude, which are counted from -180 to 180, and a latitude.
  [[nodiscard]] std::string circle(const std::string& header, double longitude, bool latitude_first = false) const {
    std::string text = header + "\n";
    for (int k = 0; k < 72; ++k) {
      const double angle = k * std::numbers::pi / 36, x = longitude + 20 * std::cos(angle), y = 20 * std::sin(angle);
      const double east = x > 180 ? x - 360 : x;
      text += std::to_string(latitude_first ? y : east) + "," + std::to_string(latitude_first ? east : y) + "\n";
    }
    return put("curve.csv", text);
  }
};

TEST_F(Geographic, HeadersNameTheColumns) {
  const std::string remark = read_curve(circle("Lon [deg E],Lat [deg N]", 30), true).remark;
  EXPECT_NE(remark.find("columns named lon and lat, which are taken as x and y in that order"), std::string::npos);
  EXPECT_NE(remark.find("areas are those of the plane"), std::string::npos) << remark;
  EXPECT_EQ(remark.find("date line"), std::string::npos) << remark;
  const std::string swapped = read_curve(circle("latitude;longitude", 30, true), true).remark;
  EXPECT_NE(swapped.find("columns named latitude and longitude"), std::string::npos) << swapped;
  const std::string tecplot = read_curve(circle("VARIABLES = \"lon\" \"lat\"", 30), true).remark;
  EXPECT_NE(tecplot.find("columns named lon and lat"), std::string::npos) << tecplot;
}

TEST_F(Geographic, JumpsAreTheDateLine) {
  for (const bool latitude_first : {false, true}) {
    const std::string header = latitude_first ? "lat,lon" : "lon,lat";
    const std::string remark = read_curve(circle(header, 175, latitude_first), true).remark;
    EXPECT_NE(remark.find("segment 15 runs back across the whole map"), std::string::npos) << remark;
    EXPECT_NE(remark.find("add 360 to longitudes below 0"), std::string::npos) << remark;
  }
  const std::string unnamed = read_curve(circle("a,b", 175), true).remark;
  EXPECT_NE(unnamed.find("looks like longitudes and latitudes"), std::string::npos) << unnamed;
}

TEST_F(Geographic, DateLinesAreWarnedOfUnlessThereIsAPeriod) {
  for (const bool latitude_first : {false, true}) {
    const std::string file = circle(latitude_first ? "lat,lon" : "lon,lat", 175, latitude_first);
    const std::string warning = read_curve(file, true).warning;
    EXPECT_NE(warning.find("segment 15 runs back across the whole map"), std::string::npos) << warning;
    const Periods periods = latitude_first ? Periods{0, 360} : Periods{360, 0};
    EXPECT_EQ(read_curve(file, true, {.periods = periods}).warning, "");
  }
  EXPECT_EQ(read_curve(circle("lon,lat", 30), true).warning, "");
  const std::string greenwich = put("zero.csv", "lon,lat\n358,0\n2,0\n2,9\n358,9\n");
  EXPECT_NE(read_curve(greenwich, true).warning.find("crosses the meridian of 0"), std::string::npos);
  EXPECT_NE(read_curve(greenwich, true).remark.find("subtract 360 from longitudes above 180"), std::string::npos);
  const std::string remark = read_curve(circle("lon,lat", 175), true).remark;
  EXPECT_NE(remark.find("or give the period x=360"), std::string::npos) << remark;
}

TEST_F(Geographic, LongitudesThatAreCountedDifferentlyAreWarnedOf) {
  const auto box = [&](const std::string& header, double west, double east) {
    std::string text = header + "\n";
    for (const auto& [x, y] : {std::pair{west, 0.0}, {east, 0.0}, {east, 9.0}, {west, 9.0}}) {
      const bool latitude_first = header == "lat,lon";
      text += std::to_string(latitude_first ? y : x) + "," + std::to_string(latitude_first ? x : y) + "\n";
    }
    return read_curve(put("box.csv", text), true).curve;
  };
  for (const char* const header : {"lon,lat", "lat,lon"}) {
    const std::string warning = longitudes_warning(box(header, -170, -150), box(header, 195, 205));
    EXPECT_NE(warning.find("are from -170 to -150, those of"), std::string::npos) << warning;
    EXPECT_NE(warning.find("from 195 to 205"), std::string::npos) << warning;
    EXPECT_NE(longitudes_warning(box(header, 195, 205), box(header, -170, -150)), "");
    EXPECT_EQ(longitudes_warning(box(header, -170, -150), box(header, -160, -140)), "");
    EXPECT_EQ(longitudes_warning(box(header, -180, 180), box(header, -180, 180)), "");
    EXPECT_EQ(longitudes_warning(box(header, 0, 90), box(header, 270, 360)), "");
  }
  EXPECT_EQ(longitudes_warning(box("a,b", -170, -150), box("a,b", 195, 205)), "");
  EXPECT_EQ(longitudes_warning(box("lon,lat", -170, -150), box("a,b", 195, 205)), "");
}

TEST_F(Geographic, CurvesOfAPairHaveTheSameColumns) {
  const Curve lon_lat = read_curve(circle("lon,lat", 30), true).curve,
              lat_lon = read_curve(circle("lat,lon", 30), true).curve,
              plain = read_curve(circle("a,b", 30), true).curve;
  EXPECT_NO_THROW(require_same_columns(lon_lat, lon_lat));
  EXPECT_NO_THROW(require_same_columns(lon_lat, plain));
  EXPECT_THROW(require_same_columns(lon_lat, lat_lon), DataError);
  EXPECT_THROW(require_same_columns(lat_lon, lon_lat), DataError);
  const std::string exchanged = read_curve(circle("y,x", 30), true).remark;
  EXPECT_NE(exchanged.find("named y and x, which are taken as x and y in that order"), std::string::npos) << exchanged;
}

TEST_F(Geographic, OtherCurvesAreLeftAlone) {
  EXPECT_EQ(read_curve(circle("a,b", 30), true).remark, "");
  EXPECT_EQ(read_curve(circle("x,y", 30), true).remark, "");
  EXPECT_EQ(read_curve(circle("lon,depth", 30), true).remark, "");
  // A square whose sides are that long.
  const std::string square = put("square", "-100 -80\n100 -80\n100 80\n-100 80\n-100 -80\n");
  EXPECT_EQ(read_curve(square, true).remark, "");
  // No degrees at all.
  EXPECT_EQ(read_curve(put("metres.csv", "lon,lat\n0,0\n1e5,0\n1e5,1e5\n0,1e5\n"), true).remark, "");
}

}  // namespace
}  // namespace lober
