// Scenes of results: what their pages show, under which names and in which colours. The results stay alive until the
// pages are written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lober/curve/files.hpp"
#include "lober/operations.hpp"
#include "viewer/scene.hpp"

namespace lober::viewer {

/// Curves of any kind, each a layer of its own.
[[nodiscard]] Scene curves_scene(std::span<const Line> curves);

/// C1, C2, the pieces of their differences and their intersection, and crossings with rho and class.
[[nodiscard]] Scene overlay_scene(const operations::CurveOverlay& found);

/// The same for curves that may cross themselves, whose crossings are not listed. `c1`, `c2` are their points.
[[nodiscard]] Scene regions_scene(const operations::CurveRegions& found, CurveView c1, CurveView c2);

/// U, S, boundary, lobes, pips, sips, and the common parts of lobes where `overlaps` are known.
[[nodiscard]] Scene tangle_scene(const operations::CurveTangle& found);

/// A tangle with the common parts of leaving and entering lobes, and areas that cross by iterate.
[[nodiscard]] Scene transport_scene(const operations::SystemTransport& found);

/// The same for two curves, of which `tangle` is the tangle.
[[nodiscard]] Scene transport_scene(const operations::CurveTangle& tangle, const operations::CurveTransport& found);

/// Entrance and exit curves on the section and their images, by iterate, and their common parts.
[[nodiscard]] Scene escape_scene(const operations::SystemEscape& found);

/// The scene of a result by its operation; nothing for operations without one. Regions come without their curves.
[[nodiscard]] std::optional<Scene> scene_of(const operations::Operation& operation, const operations::Outcome& outcome);

}  // namespace lober::viewer
