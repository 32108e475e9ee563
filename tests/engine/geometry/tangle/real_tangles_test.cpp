// Real manifolds: reference values by exact rational arithmetic.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "lober/curve/files.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/shared_data.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

constexpr double relative_tolerance = 1e-12;  // what the reference values are good for

struct Manifolds {
  Curve u, s;
};
std::optional<Manifolds> read_manifolds(const std::string& set) {
  const auto u = shared_data(set + "/u.n"), s = shared_data(set + "/s.n");
  if (!u || !s) return std::nullopt;
  return Manifolds{read_curve(u->string(), false).curve, read_curve(s->string(), false).curve};
}

void expect_near(double value, double reference) {
  EXPECT_NEAR(value, reference, relative_tolerance * std::fabs(reference));
}

struct InsideOfLobe {
  std::size_t lobe;  // counted from 1, as in the reference
  double inside;
};

TEST(RealTangle, Homoclinic) {
  const auto curves = read_manifolds("run1");
  if (!curves) GTEST_SKIP() << "needs ../shared/data/run1";
  const Tangle found = tangle(curves->u, curves->s);
  EXPECT_EQ(found.nodes.crossings(), 310U);
  ASSERT_EQ(found.pips.size(), 21U);
  ASSERT_EQ(found.lobes.size(), 20U);
  EXPECT_EQ(found.boundary->bip, 10U);
  expect_near(found.boundary->area, 0.0015713447066688124);
  const std::array<Point, 11> pips{{{-0.10503778668268293, -0.00045303404744404018},
                                    {-0.10516327980066269, -0.0012067876607101688},
                                    {-0.10520987044683974, -0.00148662665479762},
                                    {-0.10560664518430812, -0.0038697883519019684},
                                    {-0.1057558002660338, -0.0047656636285518961},
                                    {-0.10709113052431697, -0.012073622288456516},
                                    {-0.10758600181554293, -0.014601097216887697},
                                    {-0.11223655832387197, -0.031684306013717696},
                                    {-0.11402837422089823, -0.035714432314957821},
                                    {-0.12918104209137371, -0.021774182152007559},
                                    {-0.13332401563821308, 0}}};
  for (std::size_t k = 0; k < pips.size(); ++k) {
    EXPECT_NEAR(found.pips[k].at.x, pips[k].x, 1e-16);
    EXPECT_NEAR(found.pips[k].at.y, pips[k].y, 1e-16);
    EXPECT_NEAR(found.pips[20 - k].at.x, pips[k].x, 1e-16);
    EXPECT_NEAR(found.pips[20 - k].at.y, -pips[k].y, 1e-16);
  }
  const std::array<double, 10> areas{2.6327857237719841e-4, 2.6452993368371091e-4, 2.6293965177081691e-4,
                                     2.6426152940943194e-4, 2.629522950661525e-4,  2.6391171898579454e-4,
                                     2.6248994531955834e-4, 2.6389115067170838e-4, 2.6041836004159463e-4,
                                     2.6353138811812819e-4};
  const std::array<double, 10> inside{
      9.71491723571675e-05, 0, 1.57984618400764e-4, 0, areas[4], 0, areas[6], 0, areas[8], 0};
  for (std::size_t k = 0; k < 20; ++k) {
    const std::size_t mirrored = k < 10 ? k : 19 - k;
    expect_near(std::fabs(found.lobes[k].area), areas[mirrored]);
    EXPECT_EQ(found.lobes[k].orientation(), k % 2 == 0 ? -1 : 1);
    if (k < 10) expect_near(found.lobes[k].inside, inside[k]);
    EXPECT_DOUBLE_EQ(found.lobes[k].inside + found.lobes[k].outside, std::fabs(found.lobes[k].area));
    EXPECT_TRUE(found.lobes[k].simple);
  }
  EXPECT_EQ(found.images.period, 2U);
  EXPECT_LT(found.images.area_change, 0.02);
}

TEST(RealTangle, HomoclinicWithAnotherBip) {
  const auto curves = read_manifolds("run1");
  if (!curves) GTEST_SKIP() << "needs ../shared/data/run1";
  const Tangle found = tangle(curves->u, curves->s, {.bip = 17});
  expect_near(found.boundary->area, 0.0018410798934265702);
  for (const auto& [lobe, inside] : {InsideOfLobe{1, 5.01680998339318e-05}, InsideOfLobe{3, 6.42481675424153e-05},
                                     InsideOfLobe{5, 7.70837094293801e-05}, InsideOfLobe{9, 1.56107196293801e-04}}) {
    expect_near(found.lobes[lobe - 1].inside, inside);
  }
  for (const std::size_t lobe : {13, 15, 17, 18, 20}) {
    EXPECT_EQ(found.lobes[lobe - 1].outside, 0) << lobe;
    EXPECT_EQ(found.lobes[lobe - 1].inside, std::fabs(found.lobes[lobe - 1].area)) << lobe;
  }
  for (const std::size_t lobe : {14, 16, 19}) EXPECT_EQ(found.lobes[lobe - 1].inside, 0) << lobe;
}

TEST(RealTangle, OverlapsOfLobes) {
  const auto curves = read_manifolds("run1");
  if (!curves) GTEST_SKIP() << "needs ../shared/data/run1";
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> found;
  for (const LobeOverlap& overlap : overlaps(tangle(curves->u, curves->s))) {
    found[{overlap.i + 1, overlap.j + 1}] = overlap.area;
  }
  const auto area = [&](std::uint32_t i, std::uint32_t j) { return found.at({i, j}); };
  expect_near(area(1, 8), 1.05062011283088e-4);
  expect_near(area(1, 10), 6.10673887369419e-5);
  expect_near(area(1, 20), 4.32165413501772e-6);
  expect_near(area(2, 17), 1.07026765455929e-5);
  expect_near(area(3, 10), 1.04955033370052e-4);
  expect_near(area(3, 16), 1.24255731378802e-5);
  expect_near(area(5, 12), 1.04311163747794e-4);
  expect_near(area(7, 20), 1.23794650567874e-5);
  expect_near(area(13, 20), 1.05062011283089e-4);
}

TEST(RealTangle, Heteroclinic) {
  const auto curves = read_manifolds("ovp5a");
  if (!curves) GTEST_SKIP() << "needs ../shared/data/ovp5a";
  const Tangle found = tangle(curves->u, curves->s);
  EXPECT_EQ(found.nodes.crossings(), 25U);
  ASSERT_EQ(found.pips.size(), 7U);
  ASSERT_EQ(found.lobes.size(), 6U);
  EXPECT_EQ(found.boundary->bip, 3U);
  expect_near(found.boundary->area, 4.5607360095726941);
  const std::array<Point, 4> pips{{{1.4437187495248724, 0.25355674402587869},
                                   {1.3871826826683114, 0.6106810865808544},
                                   {1.1408554605766186, 1.2404849518011603},
                                   {0, 2.0639268861804063}}};
  for (std::size_t k = 0; k < pips.size(); ++k) {
    EXPECT_NEAR(found.pips[k].at.x, pips[k].x, 5e-16);
    EXPECT_NEAR(found.pips[k].at.y, pips[k].y, 5e-16);
    EXPECT_NEAR(found.pips[6 - k].at.x, -pips[k].x, 5e-16);
  }
  const std::array<double, 3> areas{0.20336131661854304, 0.20629856472411115, 0.20492581346961261};
  for (std::size_t k = 0; k < 6; ++k) {
    expect_near(std::fabs(found.lobes[k].area), areas[k < 3 ? k : 5 - k]);
    const bool inside = k == 1 || k == 4;  // mirror images of each other
    EXPECT_EQ(found.lobes[k].inside, inside ? std::fabs(found.lobes[k].area) : 0);
    EXPECT_EQ(found.lobes[k].outside, inside ? 0 : std::fabs(found.lobes[k].area));
  }
}

}  // namespace
}  // namespace lober::detail
