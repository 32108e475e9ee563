// Outlines of pieces and lobes, and areas of outlines, for C.
#include <utility>

#include "engine/c/call.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::c {
namespace {

using Work = std::function<void(lober_result&)>;

void require_piece(std::size_t piece, std::size_t count, std::string_view kind) {
  if (piece < count) return;
  throw UsageError("there is no piece " + std::to_string(piece) + " of " + std::string(kind) + "; there are " +
                   std::to_string(count) + ", from 0");
}

std::vector<std::vector<Point>> polygons_of(const lober_result& of, std::string_view kind, std::size_t piece) {
  if (of.overlay) {
    for (const Pairing pairing : all_pairings) {
      if (kind != name(pairing)) continue;
      require_piece(piece, of.overlay->pieces(pairing).size(), kind);
      return outline(*of.overlay, pairing, piece);
    }
    throw UsageError("\"" + std::string(kind) +
                     "\" is not a pairing; there are c1_minus_c2, c2_minus_c1, intersection, union");
  }
  if (!of.tangle) {
    throw UsageError("the result has no outlines: only tangles and overlays have them; give the option outlines=1");
  }
  if (kind == "lobes") {
    require_piece(piece, of.tangle->lobes.size(), kind);
    return {lobe_outline(*of.tangle, piece)};
  }
  if (kind != "boundary")
    throw UsageError("\"" + std::string(kind) + "\" is not a kind of outline; there are lobes, boundary");
  require_piece(piece, of.tangle->boundary ? 1 : 0, kind);
  return {boundary_outline(*of.tangle)};
}

}  // namespace
}  // namespace lober::detail::c

int lober_outline(const lober_result* of, const char* kind, size_t piece, lober_result** result) {
  using namespace lober::detail::c;
  return operation(nullptr, result, [=](Options&) -> Work {
    if (!of || !kind) throw lober::UsageError("of or kind is a null pointer");
    return [=](lober_result& made) {
      std::vector<lober::Point> points;
      lober_result::Integers begin;
      for (const std::vector<lober::Point>& polygon : polygons_of(*of, kind, piece)) {
        begin.push_back(static_cast<std::int64_t>(points.size()));
        points.insert(points.end(), polygon.begin(), polygon.end());
      }
      made.add_points("points", std::move(points));
      made.add("begin", std::move(begin));
    };
  });
}

int lober_signed_area(const double* curve, size_t n, double* area) {
  using namespace lober::detail::c;
  return guarded([&] {
    if (!area) throw lober::UsageError("area is a null pointer");
    const lober::ClosedCurve closed = closed_curve(curve, n, "curve");
    lober::validate(closed, "curve");
    *area = lober::signed_area(closed);
  });
}
