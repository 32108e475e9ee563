// A curve without repeated vertices and of a usual size (private to densify/).
#pragma once

#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// The curve with consecutive equal vertices merged into one, so that every segment has a length, and scaled by a power
/// of two where squares of lengths would leave the range of double: a view of the caller's points where neither is
/// needed, which is nearly always. Throws DataError as `validate` and `scaled` do. O(N), parallel.
class DistinctCurve {
 public:
  explicit DistinctCurve(CurveView curve);
  DistinctCurve(const DistinctCurve&) = delete;
  DistinctCurve& operator=(const DistinctCurve&) = delete;
  [[nodiscard]] const CurveView& view() const { return view_; }
  /// A length of the caller's as one of the view; a positive one stays positive.
  [[nodiscard]] double to_view(double length) const;
  /// Points of the view as the caller's, vertices given bit for bit.
  void from_view(Buffer<Point>& points) const;

 private:
  Buffer<Point> merged_;
  std::vector<Point> scaled_;
  int exponent_ = 0;
  CurveView view_;
};

}  // namespace lober::detail
