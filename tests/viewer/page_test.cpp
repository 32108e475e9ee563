#include "viewer/page.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/utf8.hpp"
#include "lober/base/error.hpp"
#include "viewer/base64.hpp"
#include "viewer/page_data.hpp"

namespace lober::viewer {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Page, TextsCannotBecomeMarkup) {
  const std::vector<Point> points{{0, 0}, {1, 1}};
  const std::string bad = "</script><script>alert(1)</script>\"{{script}}";
  Scene scene;
  scene.title = bad;
  scene.notes = {bad};
  Layer layer;
  layer.name = bad;
  layer.colour = "#000000";
  layer.lines = {{bad, {points, false}}};
  scene.layers = {layer};
  const std::string page = page_of(scene);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
  EXPECT_EQ(page.find("unsafe"), std::string::npos);
  EXPECT_EQ(batch_page_of(bad, "{\"jobs\":[\"" + bad.substr(0, 9) + "\"]}").find("[\"</script>"), std::string::npos);
}

// Names of files are any bytes; a page is UTF-8.
TEST(Page, TextsOfAnyBytesAreUtf8) {
  const std::vector<Point> points{{0, 0}, {1, 1}};
  const std::string bytes = "caf\xe9";
  Scene scene;
  scene.title = bytes;
  scene.notes = {bytes};
  Layer layer;
  layer.name = bytes;
  layer.colour = "#000000";
  layer.lines = {{bytes, {points, false}}};
  scene.layers = {layer};
  const std::string page = page_of(scene);
  EXPECT_TRUE(detail::is_utf8(page));
  EXPECT_NE(page.find("<title>caf\u00e9"), std::string::npos);
  EXPECT_TRUE(detail::is_utf8(batch_page_of(bytes, "{}")));
}

TEST(Page, AnEmptySceneIsAPage) {
  EXPECT_NE(page_of(Scene{}).find("</html>"), std::string::npos);
}

TEST(Page, PointsAreRoundedWhereExactOnesWouldBeTooManyBytes) {
  std::vector<Point> points;
  for (int k = 0; k < 10'000; ++k) points.push_back({std::cos(1e-3 * k), std::sin(1e-3 * k)});
  Scene scene;
  Layer layer;
  layer.lines = {{"line", {points, false}}};
  scene.layers = {layer};
  const PageData exact = page_data(scene, max_exact_size), rounded = page_data(scene, 10'000);
  EXPECT_NE(exact.json.find("\"rounded\":false"), std::string::npos);
  EXPECT_NE(rounded.json.find("\"rounded\":true"), std::string::npos);
  EXPECT_LT(rounded.series.at(0).size(), exact.series.at(0).size());
  layer.lines[0].curve.points = layer.lines[0].curve.points.first(1000);
  scene.layers = {layer};
  EXPECT_EQ(page_data(scene, 0).series.at(0), page_data(scene, max_exact_size).series.at(0)) << "short ones stay exact";
}

TEST(Page, CoordinatesHaveToBeFinite) {
  const std::vector<Point> points{{0, 0}, {NAN, 1}};
  Scene scene;
  Layer layer;
  layer.lines = {{"line", {points, false}}};
  scene.layers = {layer};
  EXPECT_THROW((void)page_of(scene), DataError);
}

}  // namespace
}  // namespace lober::viewer
