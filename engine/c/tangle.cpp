// Tangles of two curves, and outlines of pieces and lobes, for C.
#include "engine/c/tangle.hpp"

#include <utility>

#include "engine/c/call.hpp"
#include "lober/error.hpp"

namespace lober::detail::c {
namespace {

using Work = std::function<void(lober_result&)>;

Work tangle_work(const double* u, std::size_t nu, const double* s, std::size_t ns, Options& given) {
  TangleOptions options;
  if (const std::int64_t bip = given.integer("bip", -1); bip >= 0) options.bip = static_cast<std::size_t>(bip);
  options.bip_near = given.point("bip_near");
  options.period = static_cast<std::uint32_t>(given.integer("period", 0));
  options.smooth = given.flag("smooth", options.smooth);
  options.check_simple = given.flag("check_simple", options.check_simple);
  options.progress = progress();
  return [=](lober_result& result) {
    add_tangle(result, std::make_shared<const Tangle>(tangle(open_curve(u, nu, "U"), open_curve(s, ns, "S"), options)),
               options.smooth);
  };
}

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
    throw UsageError("the result has no outlines: they are of a tangle, or of an overlay with the option outlines=1");
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

void add_tangle(lober_result& result, std::shared_ptr<const Tangle> tangle, bool smooth) {
  lober_result::Doubles pips, lobes, overlap_areas;
  for (const Pip& pip : tangle->pips) {
    pips.insert(pips.end(), {pip.at.x, pip.at.y, static_cast<double>(pip.rho), static_cast<double>(pip.node),
                             static_cast<double>(pip.u.segment), static_cast<double>(pip.s.segment)});
  }
  for (const Lobe& lobe : tangle->lobes) {
    const double error = smooth ? lobe.smooth_error : tangle->rounding(lobe.area);
    lobes.insert(lobes.end(), {lobe.area, lobe.inside, lobe.outside, error});
  }
  lober_result::Integers labels, pairs;
  for (const LobeLabel& label : tangle->images.labels) labels.insert(labels.end(), {label.from, label.to, label.n});
  for (const LobeOverlap& both : overlaps(*tangle)) {
    pairs.insert(pairs.end(), {both.i, both.j});
    overlap_areas.insert(overlap_areas.end(), {both.area, both.error});
  }
  result.add("pips", std::move(pips), 6);
  result.add("lobes", std::move(lobes), 4);
  result.add("labels", std::move(labels), 3);
  result.add("overlaps", std::move(pairs), 2);
  result.add("overlap_areas", std::move(overlap_areas), 2);
  result.add("period", lober_result::Integers{tangle->images.period});
  if (tangle->boundary) {
    result.add("bip", lober_result::Integers{static_cast<std::int64_t>(tangle->boundary->bip)});
    result.add("boundary_area", tangle->boundary->area);
  }
  result.tangle = std::move(tangle);
}

}  // namespace lober::detail::c

int lober_tangle(const double* u, size_t nu, const double* s, size_t ns, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return tangle_work(u, nu, s, ns, given); });
}

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
