// Curves whose images are followed, where none is given: a circle, a rectangle, the boundary of a tangle (private to
// operations/).
#pragma once

#include <span>
#include <vector>

#include "lober/dynamics/manifolds.hpp"
#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

/// The curve as points, or as a function with the parameters of its corners.
struct FollowedCurve {
  std::vector<Point> own{};
  std::span<const Point> points{};
  CurveFunction function{};
  std::vector<double> corners{};
  std::vector<Point> second{};  ///< the other boundary of a strip
};

// These write down in `found` what the curve is.
/// The circle of the numbers X, Y and R. Throws UsageError for a radius that is lost in the rounding of the centre.
[[nodiscard]] FollowedCurve followed_circle(const std::vector<double>& numbers, CurveImages& found);
[[nodiscard]] FollowedCurve followed_rectangle(const Rectangle& r, CurveImages& found);
/// On a cylinder the region lies between two boundaries, each from a saddle to its copy. Throws UsageError for a system
/// without a tangle.
[[nodiscard]] FollowedCurve followed_boundary(const System& system, double tolerance, const Context& context,
                                              CurveImages& found);

}  // namespace lober::detail::table
