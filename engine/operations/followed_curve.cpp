#include "engine/operations/followed_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/base/text.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

std::string in_words(Point point) {
  return "(" + format_rounded(point.x, 10) + ", " + format_rounded(point.y, 10) + ")";
}

}  // namespace

FollowedCurve followed_circle(const std::vector<double>& numbers, CurveImages& found) {
  const Point centre{numbers[0], numbers[1]};
  const double radius = numbers[2];
  found.what = "circle of radius " + format_rounded(radius, 10) + " about " + in_words(centre);
  FollowedCurve given;
  given.function = [centre, radius](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double turn = parameters[k] == 1 ? 0 : parameters[k], angle = 2 * std::numbers::pi * turn;
      points[k] = {centre.x + radius * elementary::cos(angle), centre.y + radius * elementary::sin(angle)};
    }
  };
  // Else all of its points are one, or two.
  const double largest = std::max(std::fabs(centre.x), std::fabs(centre.y));
  if (!(largest + radius / 4 > largest)) {
    throw UsageError("option \"circle\": the radius " + format_number(radius) + " is lost in the rounding of " +
                     in_words(centre));
  }
  given.corners = {0, 1};
  given.own = {{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}};
  given.points = given.own;
  return given;
}

FollowedCurve followed_rectangle(const Rectangle& r, CurveImages& found) {
  found.what = "rectangle [" + format_rounded(r.min_x, 10) + ", " + format_rounded(r.max_x, 10) + "] x [" +
               format_rounded(r.min_y, 10) + ", " + format_rounded(r.max_y, 10) + "]";
  FollowedCurve given;
  given.own = {{r.min_x, r.min_y}, {r.max_x, r.min_y}, {r.max_x, r.max_y}, {r.min_x, r.max_y}};
  given.points = given.own;
  return given;
}

FollowedCurve followed_boundary(const System& system, double tolerance, const Context& context, CurveImages& found) {
  if (!system.connection) {
    throw UsageError("system " + system.info.name + " names no tangle whose boundary could be taken; give a curve");
  }
  ManifoldTangleOptions options;
  options.tolerance = tolerance;
  options.progress = context.progress;
  found.closed = !system.further_needed;
  std::vector<Connection> connections{*system.connection};
  if (system.further_needed) connections.insert(connections.end(), system.further.begin(), system.further.end());
  FollowedCurve given;
  for (const Connection& connection : connections) {
    const auto tangle = grow_tangle(*system.map, connection, options);
    found.what += (found.what.empty() ? "" : " and ") + std::string("boundary with the bip ") +
                  in_words(tangle->tangle.pips[tangle->bip].at);
    found.bips.push_back(tangle->tangle.pips[tangle->bip].at);
    (given.own.empty() ? given.own : given.second) = boundary_curve(*tangle);
  }
  given.points = given.own;
  return given;
}

}  // namespace lober::detail::table
