#include "engine/batch/operations/prepared_curve.hpp"

#include <cmath>

#include "engine/base/text.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail {
namespace {

// The message of what `work` throws; empty if it does not throw.
template <typename Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

PreparedCurve::PreparedCurve(std::shared_ptr<const Curve> curve, const Requirements& requirements, std::string warning)
    : curve_(std::move(curve)), warning_(std::move(warning)) {
  const Curve& given = *curve_;
  error_ = refusal([&] {
    if (requirements.index || requirements.simple) {
      require_enough_vertices(given, given.name);
      index_.emplace(CurveView(given));
      if (index_->finite()) return;
    }
    validate(given, given.name);
  });
  if (!error_.empty()) return;
  if (!given.closed) not_closed_ = given.name + ": is open, a closed curve is needed";
  if (requirements.simple) {
    not_simple_ = refusal([&] {
      try {
        (void)require_simple(*index_, 1);
      } catch (const NotSimpleError& error) {
        throw DataError(given.name + ": is not simple: segments " + std::to_string(error.segment1) + " and " +
                        std::to_string(error.segment2) + " meet at " + format_point(error.at) +
                        (given.closed ? "; operation = \"regions\" takes such curves" : ""));
      }
    });
  }
  if (requirements.discretisation && given.closed) sums_.emplace(CurveView(given));
}

const std::string& PreparedCurve::error(const Requirements& requirements) const {
  if (!error_.empty()) return error_;
  if ((requirements.closed || requirements.discretisation) && !not_closed_.empty()) return not_closed_;
  return requirements.simple ? not_simple_ : error_;
}

std::size_t PreparedCurve::memory() const {
  return sizeof(*this) + curve_->points.capacity() * sizeof(Point) + (index_ ? index_->memory() : 0) +
         (sums_ ? sums_->memory() : 0);
}

}  // namespace lober::detail
