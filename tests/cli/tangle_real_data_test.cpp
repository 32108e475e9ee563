// Tangles of real manifolds against exact rational areas of the polygons, and against the files of the published
// program. Lobes and pips count from 0 here.

#include <cmath>
#include <map>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"
#include "tests/shared_data.hpp"
#include "tests/views.hpp"

namespace lober::cli {
using namespace lober::detail;
namespace {

class RealTangle : public ProgramTest {
 protected:
  void find(const std::string& set) {
    const auto u = shared_data(set + "/u.n"), s = shared_data(set + "/s.n");
    if (!u || !s) GTEST_SKIP() << "the real manifolds are not there: data/" << set;
    u_ = *u;
    s_ = *s;
    folder_of_data_ = u->parent_path().string();
  }
  [[nodiscard]] Json found(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {u_, s_});
    return tangle(more);
  }
  [[nodiscard]] std::string data(const std::string& name) const { return folder_of_data_ + "/" + name; }
  [[nodiscard]] const std::string& u() const { return u_; }
  [[nodiscard]] const std::string& s() const { return s_; }

  static void expect_close(const Json& value, double expected, double tolerance, const std::string& what) {
    EXPECT_NEAR(value.get<double>(), expected, tolerance * std::fabs(expected)) << what;
  }
  static void expect_lobes(const Json& lobes, const std::vector<double>& first_half) {
    ASSERT_EQ(lobes.size(), 2 * first_half.size());
    int orientation = lobes[0]["area"].get<double>() > 0 ? 1 : -1;
    for (std::size_t k = 0; k < lobes.size(); ++k, orientation = -orientation) {
      const double area = first_half[std::min(k, lobes.size() - 1 - k)];
      expect_close(lobes[k]["area"], orientation * area, 2e-15, "lobe " + std::to_string(k));
      expect_close(Json(lobes[k]["inside"].get<double>() + lobes[k]["outside"].get<double>()), area, 2e-15,
                   "sides of lobe " + std::to_string(k));
      EXPECT_EQ(lobes[k]["simple"], true);
    }
  }
  static constexpr double all = -1;
  static void expect_inside(const Json& lobes, const std::map<std::size_t, double>& inside) {
    for (const auto& [k, area] : inside) {
      const double whole = std::fabs(lobes[k]["area"].get<double>());
      EXPECT_NEAR(lobes[k]["inside"], area == all ? whole : area, 2e-15 * whole) << "lobe " << k;
    }
  }

  // The same zones with the same titles; coordinates to an ulp or two: both programs round.
  void expect_same_points(const std::string& ours, const std::string& theirs) {
    const CurveFile mine = read_curve_file(folder() / ours), other = read_curve_file(data(theirs));
    ASSERT_EQ(mine.zones.size(), other.zones.size()) << theirs;
    for (std::size_t k = 0; k < mine.zones.size(); ++k) {
      const Zone &a = mine.zones[k], &b = other.zones[k];
      EXPECT_EQ(a.title, b.title);
      ASSERT_EQ(a.points.size(), b.points.size()) << theirs << ' ' << a.title;
      for (std::size_t m = 0; m < a.points.size(); ++m) {
        const double extent = std::hypot(b.points[m].x, b.points[m].y);
        EXPECT_NEAR(a.points[m].x, b.points[m].x, 3e-16 * extent) << theirs << ' ' << a.title << ' ' << m;
        EXPECT_NEAR(a.points[m].y, b.points[m].y, 3e-16 * extent) << theirs << ' ' << a.title << ' ' << m;
      }
    }
  }

 private:
  std::string u_, s_, folder_of_data_;
};

class HomoclinicTangle : public RealTangle {
 protected:
  void SetUp() override { find("run1"); }
};

TEST_F(HomoclinicTangle, HasTheExactAreas) {
  const Json result = found({"--overlaps"});
  EXPECT_EQ(result["crossings"]["count"], 310);
  ASSERT_EQ(result["pips"].size(), 21U);
  expect_close(result["pips"][0]["x"], -0.10503778668268293, 1e-15, "x of pip 0");
  expect_close(result["pips"][7]["y"], -0.031684306013717696, 1e-15, "y of pip 7");
  EXPECT_EQ(result["bip"]["index"], 10);
  expect_lobes(result["lobes"],
               {2.6327857237719841e-4, 2.6452993368371091e-4, 2.6293965177081691e-4, 2.6426152940943194e-4,
                2.629522950661525e-4, 2.6391171898579454e-4, 2.6248994531955834e-4, 2.6389115067170838e-4,
                2.6041836004159463e-4, 2.6353138811812819e-4});
  expect_close(result["boundary"]["area"], 0.0015713447066688124, 2e-15, "boundary");
  expect_inside(result["lobes"], {{0, 9.71491723571675e-05},
                                  {1, 0},
                                  {2, 1.57984618400764e-4},
                                  {3, 0},
                                  {4, all},
                                  {5, 0},
                                  {6, all},
                                  {7, 0},
                                  {8, all},
                                  {9, 0}});
  std::map<std::pair<int, int>, double> overlaps;
  for (const Json& both : result["overlaps"]) overlaps[{both["i"], both["j"]}] = both["area"];
  const std::map<std::pair<int, int>, double> expected{
      {{0, 7}, 1.05062011283088e-4},  {{0, 9}, 6.10673887369419e-5},  {{0, 19}, 4.32165413501772e-6},
      {{1, 16}, 1.07026765455929e-5}, {{2, 9}, 1.04955033370052e-4},  {{2, 15}, 1.24255731378802e-5},
      {{4, 11}, 1.04311163747794e-4}, {{6, 19}, 1.23794650567874e-5}, {{12, 19}, 1.05062011283089e-4}};
  for (const auto& [pair, area] : expected) {
    EXPECT_NEAR(overlaps[pair], area, 2e-14 * area) << pair.first << ' ' << pair.second;
  }
  EXPECT_EQ(result["images"]["period"], 2);
}

TEST_F(HomoclinicTangle, HasTheExactAreasWithAnotherBip) {
  const Json result = found({"--bip", "17"});
  expect_close(result["boundary"]["area"], 0.0018410798934265702, 2e-15, "boundary");
  expect_inside(result["lobes"], {{0, 5.01680998339318e-05},
                                  {2, 6.42481675424153e-05},
                                  {4, 7.70837094293801e-05},
                                  {8, 1.56107196293801e-04},
                                  {12, all},
                                  {13, 0},
                                  {14, all},
                                  {15, 0},
                                  {16, all},
                                  {17, all},
                                  {18, 0},
                                  {19, all}});
}

TEST_F(HomoclinicTangle, WritesTheFilesOfLober18) {
  const Outcome outcome = run({u(), s(), "lobe.dat", "mani.dat", "pips.dat", "0", "0", "1", "lobeb.dat", "-BIP", "17"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* name : {"pips.dat", "lobeb.dat", "separ.dat"}) expect_same_points(name, name);
}

class VortexTangle : public RealTangle {
 protected:
  void SetUp() override { find("ovp5a"); }
};

TEST_F(VortexTangle, HasTheExactAreas) {
  const Json result = found({"--overlaps"});
  EXPECT_EQ(result["crossings"]["count"], 25);
  ASSERT_EQ(result["pips"].size(), 7U);
  EXPECT_EQ(result["bip"]["index"], 3);
  expect_close(result["bip"]["y"], 2.0639268861804063, 2e-16, "bip");
  expect_lobes(result["lobes"], {0.20336131661854304, 0.20629856472411115, 0.20492581346961261});
  expect_close(result["boundary"]["area"], 4.5607360095726941, 2e-15, "boundary");
  expect_inside(result["lobes"], {{0, 0}, {1, all}, {2, 0}, {3, 0}, {4, all}, {5, 0}});
}

TEST_F(VortexTangle, ReadsBothManifoldsFromOneFile) {
  EXPECT_EQ(tangle({data("mani.dat#0"), data("mani.dat#1")})["lobes"], found()["lobes"]);
}

TEST_F(VortexTangle, WritesTheFilesOfLober18) {
  const std::string both = data("mani.dat");
  const Outcome outcome = run({both, both, "lobe.dat", "mani.dat", "pips.dat", "0", "1", "1", "lobeb.dat"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* name : {"mani.dat", "pips.dat", "lobeb.dat", "separ.dat"}) expect_same_points(name, name);
}

}  // namespace
}  // namespace lober::cli
