// The operations on views, whose kind is checked when they run instead of by the compiler (private to the engine, and
// for tests). Points must outlive the results. Otherwise as the functions of the same names in engine/lober/; an open
// curve where a closed one belongs, or the other way round, is a UsageError.
#pragma once

#include <optional>

#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::detail {

[[nodiscard]] Overlay overlay(CurveView c1, CurveView c2, const OverlayOptions& options = {});
[[nodiscard]] InteriorAreas interior_areas(CurveView c1, CurveView c2, const InteriorOptions& options = {});
[[nodiscard]] Regions regions(CurveView c1, std::optional<CurveView> c2 = {}, const RegionOptions& options = {});
[[nodiscard]] Tangle tangle(CurveView u, CurveView s, const TangleOptions& options = {});
[[nodiscard]] SmoothArea smooth_area(CurveView curve);
[[nodiscard]] CommonArea common_area(CurveView first, CurveView second);

}  // namespace lober::detail
