#include "cli/tangle/manifold_lift.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <tuple>

namespace lober::cli {
namespace {

constexpr double same_point = 1e-6;  // in periods

// The side to which a manifold leaves its first point: where it is an eighth of a period away, or where it ends.
int heading(std::span<const Point> curve, double Point::*coordinate, double period) {
  const double begin = curve.front().*coordinate;
  double away = 0;
  for (const Point& point : curve) {
    away = point.*coordinate - begin;
    if (std::fabs(away) >= 0.125 * period) break;
  }
  return away > 0 ? 1 : away < 0 ? -1 : 0;
}

// Periods by which S has to be moved for its saddle to be where U leads; nothing where headings do not tell.
bool sheets_by_headings(std::span<const Point> s, std::span<const Point> u, double Point::*coordinate, double period,
                        double& sheets) {
  const double apart = (s.front().*coordinate - u.front().*coordinate) / period;
  const double nearest = std::nearbyint(apart);
  const bool same = std::fabs(apart - nearest) <= same_point;
  const int of_u = heading(u, coordinate, period), of_s = heading(s, coordinate, period);
  if (of_u == 0 || of_s == 0) return false;
  if (of_u == of_s) {
    sheets = -nearest;
    return same;
  }
  const double next = same ? nearest - of_u : of_u > 0 ? std::floor(apart) : std::ceil(apart);
  sheets = -next;
  return true;
}

}  // namespace

std::string lift_manifold(std::span<Point> s, std::span<const Point> u, Periods periods) {
  if (!periods.any() || s.empty() || u.empty()) return {};
  const Point before = s.front();
  bool by_headings = true;
  for (const auto& [coordinate, period, only] : {std::tuple(&Point::x, periods.x, Periods{periods.x, 0}),
                                                 std::tuple(&Point::y, periods.y, Periods{0, periods.y})}) {
    if (period == 0) continue;
    double sheets = 0;
    if (sheets_by_headings(s, u, coordinate, period, sheets)) {
      if (sheets == 0) continue;
      for (Point& point : s) point.*coordinate += sheets * period;
    } else {
      by_headings = false;
      move_near(s, u, only);
    }
  }
  const auto moved = [](double from, double to, double period) {
    return period == 0 ? 0 : static_cast<long>(std::nearbyint((to - from) / period));
  };
  std::string sentence = "S is taken ";
  const long in_x = moved(before.x, s.front().x, periods.x), in_y = moved(before.y, s.front().y, periods.y);
  if (in_x == 0 && in_y == 0) sentence += "as it is stored";
  if (in_x != 0) sentence += fmt::format("{:+d} periods in x", in_x);
  if (in_y != 0) sentence += fmt::format("{}{:+d} periods in y", in_x != 0 ? " and " : "", in_y);
  sentence += fmt::format(", from ({:.8g}, {:.8g}) to meet U from ({:.8g}, {:.8g}), ", s.front().x, s.front().y,
                          u.front().x, u.front().y);
  sentence += by_headings ? "where the manifolds lead to each other" : "where the curves are nearest";
  return sentence + "; copies of S by other periods exist\n";
}

}  // namespace lober::cli
