#include "viewer/scenes/tube_overlaps.hpp"

#include <cstdlib>
#include <iterator>

#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"

namespace lober::viewer {

std::optional<TubePair> split_for_picture(const Escape& found, const EscapeFraction& row) {
  const auto& forward = found.bottlenecks[row.entry].entry;
  const auto& backward = found.bottlenecks[row.exit].exit;
  int best = -1;
  for (int a = 0; a <= row.iterates; ++a) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(row.iterates - a);
    if (i >= forward.size() || j >= backward.size() || forward[i].direction != found.section.direction) continue;
    if (best < 0 || std::abs(2 * a - row.iterates) < std::abs(2 * best - row.iterates)) best = a;
  }
  if (best < 0) return std::nullopt;
  return TubePair{&forward[static_cast<std::size_t>(best)], &backward[static_cast<std::size_t>(row.iterates - best)]};
}

Polygons common_part(const ClosedCurve& first, const ClosedCurve& second) {
  Polygons polygons;
  const auto add = [&](Polygons piece) {
    polygons.insert(polygons.end(), std::make_move_iterator(piece.begin()), std::make_move_iterator(piece.end()));
  };
  try {
    const Overlay common = overlay(first, second);
    for (std::size_t k = 0; k < common.pieces(Pairing::intersection).size(); ++k) {
      add(outline(common, Pairing::intersection, k));
    }
  } catch (const NotSimpleError&) {
    const RegionPieces pieces = regions(first, second).pieces(FillRule::nonzero, Pairing::intersection);
    for (std::size_t k = 0; k < pieces.size(); ++k) add(pieces.outline(k));
  }
  return polygons;
}

}  // namespace lober::viewer
