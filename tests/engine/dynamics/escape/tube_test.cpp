// Tubes against areas by action in quadruple precision.
#include <gtest/gtest.h>

#include "kernels/box.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/transport/escape.hpp"

namespace lober::detail {
namespace {

TEST(Tube, EnclosesTheActionOfItsOrbit) {
  const System ship = make_system("capsize");
  EscapeOptions options;
  options.tolerance = 1e-7;
  options.integration.tolerance = 1e-14;
  const auto found = bottlenecks(*ship.flow, *ship.section, 0.25307, std::vector<FlowState>{ship.saddles[1]}, options);
  ASSERT_EQ(found.size(), 1U);
  const double area = 0.012534801639697775517;
  EXPECT_NEAR(found[0].area, area, 1e-12 * area);
  EXPECT_NEAR(found[0].entry[0].area, area, 1e-11 * area);
  EXPECT_NEAR(found[0].exit[0].area, area, 1e-11 * area);
  EXPECT_LE(found[0].defect_across, 1e-13);
  EXPECT_NEAR(found[0].multiplier, 39.09601030324, 1e-8);
}

TEST(Tube, OfTheThreeBodyProblemReachesTheOuterSection) {
  const System system = make_system("pcr3bp");
  EscapeOptions options;
  options.tolerance = 1e-5;
  const auto found =
      bottlenecks(*system.flow, *system.section, -1.515, std::vector<FlowState>{system.saddles[1]}, options);
  EXPECT_LT(found[0].area_defect, 1e-8);
  // The reversor (x, px) -> (x, -px) exchanges both tubes.
  const auto box_of = [](CurveView curve, double sign) {
    Box box;
    for (const Point& p : curve.points) box = union_of(box, Box::of({p.x, sign * p.y}, {p.x, sign * p.y}));
    return box;
  };
  const Box in = box_of(found[0].entry[0].image, 1), out = box_of(found[0].exit[0].image, -1);
  EXPECT_NEAR(in.min_x(), out.min_x(), 1e-4);
  EXPECT_NEAR(in.max_x(), out.max_x(), 1e-4);
  EXPECT_NEAR(in.min_y(), out.min_y(), 1e-4);
  EXPECT_NEAR(in.max_y(), out.max_y(), 1e-4);
  EXPECT_LT(in.max_x(), -1);
}

}  // namespace
}  // namespace lober::detail
