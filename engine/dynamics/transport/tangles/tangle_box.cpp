#include "engine/dynamics/transport/tangles/tangle_box.hpp"
#include "kernels/elementary.hpp"

#include <cmath>
#include <numbers>

namespace lober::detail {
namespace {

// Multiple of its size beyond which distances are no longer true.
constexpr double times_box = 64;

}  // namespace

Box scene(const LocalManifold& u, const LocalManifold& s) {
  constexpr double times = (times_scene - 1) / 2;
  Box box;
  for (const LocalManifold* local : {&u, &s}) {
    for (const double end : {-local->reach, local->reach}) box = union_of(box, Box::of(local->saddle, local->at(end)));
  }
  const double margin = times * box.extent();
  return Box::of({box.min_x() - margin, box.min_y() - margin}, {box.max_x() + margin, box.max_y() + margin});
}

Point middle_of(const Box& box) {
  return {(box.min_x() + box.max_x()) / 2, (box.min_y() + box.max_y()) / 2};
}

Box square_about(Point middle, double reach) {
  return Box::of({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach});
}

Box true_size(const Box& box) {
  return square_about(middle_of(box), times_box * box.extent() / std::numbers::sqrt2);  // within the circle
}

Box strip_along(const Box& box, Point lattice) {
  constexpr double periods = 1 << 16;
  const double x = periods * std::fabs(lattice.x), y = periods * std::fabs(lattice.y);
  return Box::of({box.min_x() - x, box.min_y() - y}, {box.max_x() + x, box.max_y() + y});
}

bool within(const Box& inner, const Box& outer) {
  return outer.min_x() <= inner.min_x() && inner.max_x() <= outer.max_x() && outer.min_y() <= inner.min_y() &&
         inner.max_y() <= outer.max_y();
}

void compress_radially(std::span<Point> points, const Box& box) {
  const Point middle = middle_of(box);
  const double radius = times_box * box.extent();
  for (Point& point : points) {
    const double dx = point.x - middle.x, dy = point.y - middle.y, r = std::hypot(dx, dy);
    if (r <= radius) continue;
    const double factor = (1 + elementary::log(r / radius)) * (radius / r);
    point = {middle.x + factor * dx, middle.y + factor * dy};
  }
}

}  // namespace lober::detail
