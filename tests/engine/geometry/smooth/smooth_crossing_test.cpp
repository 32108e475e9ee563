// Crossings of smooth curves that are moved together are those that are moved one by one.
#include "engine/geometry/smooth/smooth_crossing.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "tests/engine/geometry/smooth/shapes.hpp"
#include "tests/views.hpp"

namespace lober::smooth_test {
using namespace lober::detail;
namespace {

using CrossingSense = PolygonContact::Sense;

std::vector<PolygonContact> contacts_of(const Overlay& result) {
  const NodeGraph& graph = graph_of(result.nodes);
  std::vector<PolygonContact> contacts;
  for (std::size_t k = 0; k < graph.contacts.size(); ++k) {
    const Contact at = graph.contacts[k];
    const auto sense = at.rho > 0   ? CrossingSense::rightward_to_left
                       : at.rho < 0 ? CrossingSense::leftward_to_right
                                    : CrossingSense::stays;
    contacts.push_back({at.segment1, at.segment2, at.t1.hi, at.t2.hi, sense});
  }
  return contacts;
}

void expect_equal(const SmoothContact& a, const SmoothContact& b) {
  ASSERT_EQ(a.moved, b.moved);
  ASSERT_EQ(a.straight, b.straight);
  ASSERT_EQ(a.on1.segment, b.on1.segment);
  ASSERT_EQ(a.on1.u, b.on1.u);
  ASSERT_EQ(a.on2.segment, b.on2.segment);
  ASSERT_EQ(a.on2.u, b.on2.u);
  ASSERT_EQ(a.ends.on1, b.ends.on1);
  ASSERT_EQ(a.ends.on2, b.ends.on2);
  ASSERT_EQ(a.ends.uncertainty, b.ends.uncertainty);
}

// Waves that cross steeply, a curve sampled twice, whose crossings wander over several segments, noise with corners.
TEST(SmoothCrossing, TogetherIsOneByOne) {
  const Points wave = sample(wavy(0.1, 5), 900);
  const std::vector<std::pair<Points, Points>> curves{
      {wave, sample(ellipse(0, 0, 1, 1), 700, 0.6)},
      {sample(wavy(0.1, 12), 3000), sample(wavy(0.1, 12), 3000, 0.637)},
      {jittered(sample(wavy(0.1, 12), 3000), 3e-7, 3), jittered(sample(wavy(0.1, 12), 3000, 0.637), 3e-7, 4)},
      {jittered(wave, 1e-4, 1), jittered(wave, 1e-4, 2)},
      {sample(ellipse(0, 0, 1, 1), 7), sample(ellipse(0.3, 0.2, 1, 1), 9)},
  };
  std::size_t moved = 0, across = 0, stayed = 0;
  for (const auto& [first, second] : curves) {
    const Overlay result = overlay(CurveView{first}, CurveView{second});
    const SmoothCurve c1{CurveView{first}}, c2{CurveView{second}};
    const std::vector<PolygonContact> contacts = contacts_of(result);
    ASSERT_FALSE(contacts.empty());
    for (const bool straight_too : {false, true}) {
      std::vector<SmoothContact> together(contacts.size());
      move_contacts(c1, c2, contacts, straight_too, together);
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        SmoothContact alone;
        move_contacts(c1, c2, {&contacts[k], 1}, straight_too, {&alone, 1});
        expect_equal(alone, together[k]);
        moved += alone.moved;
        stayed += !alone.moved;
        across += alone.on1.segment != contacts[k].segment1 || alone.on2.segment != contacts[k].segment2;
      }
    }
  }
  EXPECT_GT(moved, 100U);
  EXPECT_GT(stayed, 100U);
  EXPECT_GT(across, 20U);
}

}  // namespace
}  // namespace lober::smooth_test
