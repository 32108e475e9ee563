// Each case compiles with -DRIGHT=N and must not compile with -DWRONG=N: curves of the wrong kind, and temporaries that
// would be gone.
#include <span>
#include <vector>

#include "lober/interior.hpp"
#include "lober/overlay.hpp"
#include "lober/regions.hpp"
#include "lober/smooth.hpp"
#include "lober/tangle.hpp"

using namespace lober;

void cases(const ClosedCurve& closed, const OpenCurve& open, std::vector<Point> points, CurveView view) {
#if RIGHT == 1
  (void)overlay(closed, closed);
#elif WRONG == 1
  (void)overlay(closed, open);
#elif RIGHT == 2
  (void)tangle(open, open);
#elif WRONG == 2
  (void)tangle(open, closed);
#elif RIGHT == 3
  (void)interior_areas(closed, closed);
#elif WRONG == 3
  (void)interior_areas(open, open);
#elif RIGHT == 4
  (void)regions(closed, closed);
#elif WRONG == 4
  (void)regions(closed, open);
#elif RIGHT == 5
  (void)smooth_area(closed);
#elif WRONG == 5
  (void)smooth_area(open);
#elif RIGHT == 6
  (void)overlay(ClosedCurve(points), ClosedCurve::borrow(points));
#elif WRONG == 6  // neither kind is guessed
  (void)overlay(points, points);
#elif RIGHT == 7
  const ClosedCurve owned(std::span<const Point>(points).empty() ? std::vector<Point>() : points);
#elif WRONG == 7  // a span owns nothing: say borrow
  const ClosedCurve owned{std::span<const Point>(points)};
#elif RIGHT == 8
  const CurveView seen = closed;
  (void)seen;
#elif WRONG == 8  // a view does not say which kind it is
  const ClosedCurve kind = view;
#elif RIGHT == 9
  const OpenCurve same = open;
  (void)same;
#elif WRONG == 9
  const OpenCurve same = closed;
#endif
  (void)view;
}
