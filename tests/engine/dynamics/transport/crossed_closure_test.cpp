// Transport of curves whose boundary the path that closes it crosses.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lober/tangle/tangle.hpp"
#include "lober/transport/transport.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

bool says_that_it_crosses_itself(const TransportOfCurves& found) {
  return std::any_of(found.remarks.begin(), found.remarks.end(), [](const std::string& remark) {
    return remark.find("the boundary crosses itself") != std::string::npos;
  });
}

// The signed area is a fifth of what the boundary winds round.
TEST(CrossedClosure, BoundsTheAreaThatTheTangleGives) {
  const ManifoldPair pair = wave_and_arc(100);
  for (const bool smooth : {false, true}) {
    const Tangle curves = tangle(open(pair.u), open(pair.s), {.smooth = smooth});
    const TransportOfCurves found = transport(curves, 1);
    EXPECT_EQ(found.enclosed.value, curves.boundary->area);
    EXPECT_GE(found.enclosed.error, curves.boundary->smooth_error);
    EXPECT_EQ(found.regions.front().area.value, curves.boundary->area);
    EXPECT_TRUE(says_that_it_crosses_itself(found));
  }
}

TEST(CrossedClosure, IsNotSaidOfAPathThatKeepsAway) {
  const ManifoldPair pair = wave_and_arc(100);
  TangleOptions options;
  options.smooth = true;
  options.closure = {{1.05, -0.5}, {0, -0.5}};
  const Tangle curves = tangle(open(pair.u), open(pair.s), options);
  ASSERT_FALSE(curves.boundary->crosses_itself);
  const TransportOfCurves found = transport(curves, 1);
  EXPECT_EQ(found.enclosed.value, curves.boundary->area);
  EXPECT_FALSE(says_that_it_crosses_itself(found));
}

}  // namespace
}  // namespace lober::detail
