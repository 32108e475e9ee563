#include "lober/curve/periods.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lober/base/error.hpp"

namespace lober {
namespace {

void require_period(double period) {
  if (!(period >= 0) || !std::isfinite(period)) throw UsageError("a period has to be positive");
}

// `sheets` times the period is subtracted from each number at once, so that no rounding adds up along a curve.
template <double Point::*coordinate>
std::size_t unwrap_one(std::span<Point> points, double period) {
  require_period(period);
  if (period == 0 || points.empty()) return 0;
  std::size_t crossings = 0;
  double before = points[0].*coordinate, sheets = 0;
  for (Point& point : points) {
    const double raw = point.*coordinate;
    const double step = raw - before;
    if (std::fabs(step) > 0.5 * period) {
      sheets += std::nearbyint(step / period);
      ++crossings;
    }
    before = raw;
    point.*coordinate = raw - sheets * period;
  }
  return crossings;
}

template <double Point::*coordinate>
double middle_of(std::span<const Point> points) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Point& point : points) {
    low = std::min(low, point.*coordinate);
    high = std::max(high, point.*coordinate);
  }
  return 0.5 * low + 0.5 * high;
}

template <double Point::*coordinate>
void move_one(std::span<Point> points, std::span<const Point> others, double period) {
  require_period(period);
  if (period == 0 || points.empty() || others.empty()) return;
  const double sheets = std::nearbyint((middle_of<coordinate>(points) - middle_of<coordinate>(others)) / period);
  if (sheets == 0) return;
  for (Point& point : points) point.*coordinate -= sheets * period;
}

}  // namespace

std::size_t unwrap(std::span<Point> points, Periods periods) {
  return unwrap_one<&Point::x>(points, periods.x) + unwrap_one<&Point::y>(points, periods.y);
}

void move_near(std::span<Point> points, std::span<const Point> others, Periods periods) {
  move_one<&Point::x>(points, others, periods.x);
  move_one<&Point::y>(points, others, periods.y);
}

std::string period_warning(const Curve& first, const Curve& second, Periods periods) {
  if (!periods.any()) return {};
  Rectangle box;
  for (const Curve* const curve : {&first, &second}) {
    for (const Point& point : curve->points) box.add(point);
  }
  const bool in_x = periods.x != 0 && box.width() > periods.x, in_y = periods.y != 0 && box.height() > periods.y;
  if (!in_x && !in_y) return {};
  const std::string names = first.name.empty() || second.name.empty() ? "" : " " + first.name + " and " + second.name;
  return "the curves" + names + " are together wider than the period of " + (in_x ? "x" : "y") +
         ": they could also meet where one of them is moved by a period, which is not counted";
}

}  // namespace lober
