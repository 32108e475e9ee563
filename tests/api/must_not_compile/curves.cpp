// Each case compiles with -DRIGHT=N and must not compile with -DWRONG=N: curves of the wrong kind, and temporaries that
// would be gone.
#include <ranges>
#include <span>
#include <type_traits>
#include <vector>

#include "lober/curve/densify.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/tubes.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/tangle.hpp"

using namespace lober;

// Elements are made when asked for, and all algorithms on ranges take them.
static_assert(std::ranges::random_access_range<Pieces> && std::ranges::sized_range<Pieces>);
static_assert(std::ranges::random_access_range<RegionPieces> && std::ranges::sized_range<RegionPieces>);
static_assert(std::ranges::forward_range<PieceCrossings>);
// A loop over the pieces of a temporary keeps them alive.
static_assert(std::is_same_v<decltype(Overlay().pieces(Pairing::union_)), Pieces>);

Curve a_curve();
DensifiedCurve a_densified_curve();
GrownManifold a_manifold();
CurveImage an_image();
TubeCurve a_tube_curve();

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
#elif RIGHT == 10
  const Curve named = a_curve();
  (void)IndexedCurve(named);
#elif WRONG == 10  // the index would show points that are gone; so in the next cases
  (void)IndexedCurve(a_curve());
#elif RIGHT == 11
  (void)IndexedCurve(ClosedCurve(points));  // keeps what the curve owns
#elif WRONG == 11
  const CurveView seen = ClosedCurve(points);
#elif RIGHT == 12
  const CurveView seen = open;
  (void)seen;
#elif WRONG == 12
  const CurveView seen = OpenCurve(points);
#elif RIGHT == 13
  const DiscretisationSums sums(closed);
#elif WRONG == 13
  const DiscretisationSums sums(ClosedCurve{std::vector<Point>(points)});
#elif RIGHT == 14
  const DensifiedCurve named = a_densified_curve();
  (void)IndexedCurve(named);
#elif WRONG == 14
  (void)IndexedCurve(a_densified_curve());
#elif RIGHT == 15
  const GrownManifold named = a_manifold();
  (void)IndexedCurve(named);
#elif WRONG == 15
  (void)IndexedCurve(a_manifold());
#elif RIGHT == 16
  const CurveImage named = an_image();
  (void)IndexedCurve(named);
#elif WRONG == 16
  (void)IndexedCurve(an_image());
#elif RIGHT == 17
  const Overlay result = overlay(closed, closed);
  const Piece piece = result.pieces(Pairing::union_)[0];
  (void)piece;
#elif WRONG == 17
  const Piece piece = overlay(closed, closed).pieces(Pairing::union_)[0];
#elif RIGHT == 18
  for (const Piece piece : overlay(closed, closed).pieces(Pairing::union_)) (void)piece;
#elif WRONG == 18
  for (const double area : overlay(closed, closed).pieces(Pairing::union_).areas()) (void)area;
#elif RIGHT == 19
  for (const RegionPiece piece : regions(closed).pieces(FillRule::nonzero, Pairing::union_)) (void)piece;
#elif WRONG == 19
  for (const double area : regions(closed).pieces(FillRule::nonzero, Pairing::union_).areas()) (void)area;
#elif RIGHT == 20
  const Regions result = regions(closed);
  for (const WindingArea& entry : result.table()) (void)entry;
#elif WRONG == 20
  for (const WindingArea& entry : regions(closed).table()) (void)entry;
#elif RIGHT == 21
  const Overlay result = overlay(closed, closed);
  for (const std::uint32_t node : result.nodes.order2()) (void)node;
#elif WRONG == 21
  for (const std::uint32_t node : overlay(closed, closed).nodes.order2()) (void)node;
#elif RIGHT == 22
  for (const Point& point : closed.points()) (void)point;
#elif WRONG == 22
  for (const Point& point : ClosedCurve(points).points()) (void)point;
#elif RIGHT == 23
  const IndexedCurve indexed(closed);
  (void)indexed.view();
#elif WRONG == 23
  const CurveView seen = IndexedCurve(ClosedCurve(points)).view();
#elif RIGHT == 24
  const Tangle found = tangle(open, open);
  (void)found.u();
#elif WRONG == 24
  const CurveView seen = tangle(OpenCurve(points), open).u();
#elif RIGHT == 25
  const TubeCurve named = a_tube_curve();
  (void)common_area(named.view(), named.view());
#elif WRONG == 25
  (void)common_area(a_tube_curve().view(), closed);
#endif
  (void)view;
}
