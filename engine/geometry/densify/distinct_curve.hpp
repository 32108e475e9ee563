// A curve without repeated vertices (private to densify/).
#pragma once

#include "lober/buffer.hpp"
#include "lober/curve.hpp"

namespace lober::detail {

/// The curve with consecutive equal vertices merged into one, so that every segment has a length: a view of the
/// caller's points where nothing repeats. Throws DataError as `validate` does. O(N), parallel.
class DistinctCurve {
 public:
  explicit DistinctCurve(CurveView curve);
  DistinctCurve(const DistinctCurve&) = delete;
  DistinctCurve& operator=(const DistinctCurve&) = delete;
  [[nodiscard]] const CurveView& view() const { return view_; }

 private:
  Buffer<Point> merged_;
  CurveView view_;
};

}  // namespace lober::detail
