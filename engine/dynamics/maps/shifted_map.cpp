#include "lober/dynamics/shifted_map.hpp"

#include <string>

#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"

namespace lober {

ShiftedMap::ShiftedMap(const PlanarMap& map, int period, Point shift) : map_(&map), period_(period), shift_(shift) {
  if (period < 1) throw UsageError("a shifted map has a period of at least 1, not " + std::to_string(period));
}

// Lost points stay lost: NaN less a shift is NaN.
void ShiftedMap::iterate(std::span<Point> points, int iterates) const {
  const Point shift = shift_of(iterates);
  map_->iterate(points, iterates);
  for (Point& point : points) point = {point.x - shift.x, point.y - shift.y};
}

Point ShiftedMap::iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const {
  const Point shift = shift_of(iterates);
  const Point image = map_->iterate_with_derivative(point, iterates, derivative);
  return {image.x - shift.x, image.y - shift.y};
}

void ShiftedMap::iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const {
  const Point shift = shift_of(iterates);
  map_->iterate_with_derivatives(points, iterates, derivatives);
  for (Point& point : points) point = {point.x - shift.x, point.y - shift.y};
}

std::unique_ptr<PlanarMap> ShiftedMap::finer() const {
  std::unique_ptr<PlanarMap> finer = map_->finer();
  if (!finer) return nullptr;
  auto shifted = std::make_unique<ShiftedMap>(*finer, period_, shift_);
  shifted->owned_ = std::move(finer);
  return shifted;
}

Point ShiftedMap::shift_of(int iterates) const {
  if (iterates % period_ != 0) {
    throw UsageError("a map shifted after " + std::to_string(period_) + " iterates has no image after " +
                     std::to_string(iterates));
  }
  const double times = iterates / period_;
  return {times * shift_.x, times * shift_.y};
}

}  // namespace lober
