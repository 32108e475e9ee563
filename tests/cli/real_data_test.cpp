// Lobes of real manifolds against each other and against the boundary, with which they share arcs. The
// reference values are exact rational areas of the polygons as given.

#include <cmath>
#include <map>

#include "tests/cli/program.hpp"
#include "tests/shared_data.hpp"

namespace lober::cli {
namespace {

// The lobes of a manifold pair: zone k of lobeb.dat is lobe k + 1.
class RealData : public ProgramTest {
 protected:
  void find(const std::string& set, int lobes) {
    const auto lobe_file = shared_data(set + "/lobeb.dat"), boundary_file = shared_data(set + "/separ.dat");
    if (!lobe_file || !boundary_file) GTEST_SKIP() << "the real manifolds are not there: data/" << set;
    lobe_file_ = *lobe_file;
    boundary_ = *boundary_file;
    lobes_ = lobes;
  }
  [[nodiscard]] std::string lobe(int number) const { return lobe_file_ + "#" + std::to_string(number - 1); }
  [[nodiscard]] const std::string& boundary() const { return boundary_; }
  [[nodiscard]] int lobes() const { return lobes_; }

  static void expect_consistent(const Json& areas, const std::string& what) {
    const double c1 = areas["c1"], c2 = areas["c2"], both = areas["intersection"];
    EXPECT_NEAR(both + areas["c1_minus_c2"].get<double>(), c1, 1e-12 * c1) << what;
    EXPECT_NEAR(both + areas["c2_minus_c1"].get<double>(), c2, 1e-12 * c2) << what;
  }

  // The area of each lobe inside the boundary: a number, or all, or none (up to rounding of shared arcs).
  void check_boundary(double boundary_area, const std::map<int, double>& areas, const std::map<int, double>& inside) {
    for (int k = 1; k <= lobes(); ++k) {
      const Json verified = overlay({lobe(k), boundary(), "--verify"});
      const Json& result = verified["areas"];
      const std::string what = "lobe " + std::to_string(k);
      // The interior method agrees, and is another run of its own.
      const Json other = interior({lobe(k), boundary()})["areas"];
      for (const auto& [name, difference] : verified["error"]["consistency"].items()) {
        const double area = result[name];
        EXPECT_LE(difference, 1e-15 * area + 1e-27 * result["c2"].get<double>()) << what << ' ' << name;
        EXPECT_EQ(difference, std::fabs(area - other[name].get<double>())) << what << ' ' << name;
      }
      expect_consistent(result, what);
      EXPECT_NEAR(result["c2"], boundary_area, 1e-15 * boundary_area) << what;
      const double area = areas.at(std::min(k, lobes() + 1 - k));
      EXPECT_NEAR(result["c1"], area, 2e-15 * area) << what;
      if (inside.contains(k)) {
        EXPECT_NEAR(result["intersection"], inside.at(k), 2e-15 * area) << what;
      }
    }
  }

  void check_pairs(const std::map<std::pair<int, int>, double>& overlaps) {
    for (int i = 1; i <= lobes(); ++i) {
      for (int j = i; j <= lobes(); ++j) {
        const Json result = overlay({lobe(i), lobe(j)})["areas"];
        const std::string what = "lobes " + std::to_string(i) + " and " + std::to_string(j);
        expect_consistent(result, what);
        if (i == j) {
          EXPECT_EQ(result["symmetric_difference"], 0.0) << what;
        }
        if (overlaps.contains({i, j})) {
          EXPECT_NEAR(result["intersection"], overlaps.at({i, j}), 5e-14 * overlaps.at({i, j})) << what;
        }
      }
    }
  }

 private:
  std::string lobe_file_, boundary_;
  int lobes_ = 0;
};

class VortexPair : public RealData {
 protected:
  void SetUp() override { find("ovp5a", 6); }
};

TEST_F(VortexPair, LobesAgainstTheBoundary) {
  const std::map<int, double> areas{{1, 0.20336131661854304}, {2, 0.20629856472411115}, {3, 0.20492581346961261}};
  check_boundary(4.5607360095726941, areas, {{1, 0}, {2, areas.at(2)}, {3, 0}, {4, 0}, {5, areas.at(2)}, {6, 0}});
}

TEST_F(VortexPair, LobesAgainstEachOther) {
  check_pairs({});
}

class Homoclinic : public RealData {
 protected:
  void SetUp() override { find("run1", 20); }
};

const std::map<int, double> homoclinic_areas{
    {1, 2.6327857237719841e-4}, {2, 2.6452993368371091e-4}, {3, 2.6293965177081691e-4}, {4, 2.6426152940943194e-4},
    {5, 2.629522950661525e-4},  {6, 2.6391171898579454e-4}, {7, 2.6248994531955834e-4}, {8, 2.6389115067170838e-4},
    {9, 2.6041836004159463e-4}, {10, 2.6353138811812819e-4}};

TEST_F(Homoclinic, LobesAgainstTheBoundary) {
  const auto all = [](int lobe) { return homoclinic_areas.at(std::min(lobe, 21 - lobe)); };
  check_boundary(0.0018410798934265702, homoclinic_areas,
                 {{1, 5.01680998339318e-05},
                  {3, 6.42481675424153e-05},
                  {5, 7.70837094293801e-05},
                  {9, 1.56107196293801e-04},
                  {13, all(13)},
                  {14, 0},
                  {15, all(15)},
                  {16, 0},
                  {17, all(17)},
                  {18, all(18)},
                  {19, 0},
                  {20, all(20)}});
}

TEST_F(Homoclinic, LobesAgainstEachOther) {
  check_pairs({{{1, 8}, 1.05062011283088e-4},
               {{1, 10}, 6.10673887369419e-5},
               {{1, 20}, 4.32165413501772e-6},
               {{2, 17}, 1.07026765455929e-5},
               {{3, 10}, 1.04955033370052e-4},
               {{3, 16}, 1.24255731378802e-5},
               {{5, 12}, 1.04311163747794e-4},
               {{7, 20}, 1.23794650567874e-5},
               {{13, 20}, 1.05062011283089e-4}});
}

}  // namespace
}  // namespace lober::cli
