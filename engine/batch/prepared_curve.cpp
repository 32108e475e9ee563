#include "engine/batch/prepared_curve.hpp"

#include <cmath>

#include "engine/geometry/crossings/crossings.hpp"
#include "engine/geometry/curve/scaled.hpp"

namespace lober {
namespace {

// As in `overlay`: coordinates so large or small that products leave the range of double are scaled first.
void check_simple(const IndexedCurve& index) {
  const int exponent = comfortable_exponent(index.tree().box());
  if (exponent == 0) {
    (void)require_simple(index, 1);
    return;
  }
  const std::vector<Point> points = scaled(index.view(), exponent);
  (void)require_simple(IndexedCurve(CurveView{points, index.view().closed}), 1, exponent);
}

}  // namespace

PreparedCurve::PreparedCurve(std::shared_ptr<const Curve> curve, const Needs& needs) : curve_(std::move(curve)) {
  const Curve& given = *curve_;
  try {
    if (needs.index || needs.simple) {
      require_enough_vertices(given, given.name);
      index_.emplace(CurveView(given));
      if (!index_->tree().sums_finite()) validate(given, given.name);
    } else {
      validate(given, given.name);
    }
    if (needs.closed && !given.closed) throw DataError(given.name + ": is open, a closed curve is needed");
    if (needs.simple) {
      try {
        check_simple(*index_);
      } catch (const NotSimpleError& error) {
        throw DataError(given.name + ": is not simple: segments " + std::to_string(error.segment1) + " and " +
                        std::to_string(error.segment2) + " meet");
      }
    }
    if (needs.discretisation) sums_.emplace(CurveView(given));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    error_ = error.what();
  }
}

std::size_t PreparedCurve::memory() const {
  return sizeof(*this) + curve_->points.capacity() * sizeof(Point) + (index_ ? index_->tree().memory() : 0) +
         (sums_ ? sums_->memory() : 0);
}

}  // namespace lober
