#include "engine/batch/operations/prepared_curve.hpp"

#include <cmath>

#include "lober/overlay/crossings.hpp"

namespace lober::detail {
PreparedCurve::PreparedCurve(std::shared_ptr<const Curve> curve, const Requirements& requirements, std::string warning)
    : curve_(std::move(curve)), warning_(std::move(warning)) {
  const Curve& given = *curve_;
  try {
    if (requirements.index || requirements.simple) {
      require_enough_vertices(given, given.name);
      index_.emplace(CurveView(given));
      if (!index_->finite()) validate(given, given.name);
    } else {
      validate(given, given.name);
    }
    if (requirements.closed && !given.closed) throw DataError(given.name + ": is open, a closed curve is needed");
    if (requirements.simple) {
      try {
        (void)require_simple(*index_, 1);
      } catch (const NotSimpleError& error) {
        throw DataError(given.name + ": is not simple: segments " + std::to_string(error.segment1) + " and " +
                        std::to_string(error.segment2) + " meet");
      }
    }
    if (requirements.discretisation) sums_.emplace(CurveView(given));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    error_ = error.what();
  }
}

std::size_t PreparedCurve::memory() const {
  return sizeof(*this) + curve_->points.capacity() * sizeof(Point) + (index_ ? index_->memory() : 0) +
         (sums_ ? sums_->memory() : 0);
}

}  // namespace lober::detail
