// What tubes of an escape have in common on a section: for pages and for the program's pictures.
#pragma once

#include <optional>

#include "lober/curve/curve.hpp"
#include "lober/transport/escape.hpp"
#include "viewer/scene.hpp"

namespace lober::viewer {

/// Two curves on the section.
struct TubePair {
  const TubeCurve* from;
  const TubeCurve* to;
};

/// The curves of a split of the row, of an entrance and an exit, with that of the entrance on this side of the section:
/// the split that is as even as can be. Nothing if there is none. They are as valid as the result. O(iterates).
[[nodiscard]] std::optional<TubePair> split_for_picture(const Escape& found, const EscapeFraction& row);

/// Rings of what both curves wind about. They may cross themselves, as cut images do, and curves of a section that
/// tubes meet more than once. As an overlay of both, or regions.
[[nodiscard]] Polygons common_part(const ClosedCurve& first, const ClosedCurve& second);

}  // namespace lober::viewer
