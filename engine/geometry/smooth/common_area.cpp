#include <cmath>

#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober {
using namespace detail;

CommonArea common_area(const ClosedCurve& first, const ClosedCurve& second) {
  try {
    OverlayOptions options;
    options.pieces = false;
    const SmoothAreas smooth = smooth_areas(overlay(first, second, options));
    return {smooth.areas.intersection, smooth.error.intersection};
  } catch (const NotSimpleError&) {
    const Areas areas = regions(first, second).areas(FillRule::nonzero);
    const double uncertainty = std::fabs(areas.c1 - std::fabs(smooth_area(first).area)) +
                               std::fabs(areas.c2 - std::fabs(smooth_area(second).area));
    return {areas.intersection, uncertainty};
  }
}

}  // namespace lober
