// Transport from a tangle of curves alone, without their map.
#include <algorithm>
#include <cmath>

#include "engine/base/text.hpp"
#include "engine/dynamics/transport/tangles/barrier.hpp"
#include "engine/dynamics/transport/turnstile/comparisons.hpp"
#include "engine/dynamics/transport/turnstile/series.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"
#include "lober/transport/transport.hpp"

namespace lober {
using namespace detail;
namespace {

// How far points of two curves alone are off, by what an area-preserving map would leave unchanged: the area of a lobe
// of the turnstile and that of its image. The points come from elsewhere, and their spacing says nothing of it. (Images
// farther out may be drawn coarsely.)
double point_error_of(const Tangle& tangle) {
  const std::size_t period = tangle.images.period, bip = tangle.boundary->bip;
  const auto length = [&](std::size_t lobe) { return perimeter(lobe_outline(tangle, lobe)); };
  double largest = 0;
  for (std::size_t k = bip - std::min(bip, period); k < bip && k + period < tangle.lobes.size(); ++k) {
    const Lobe &lobe = tangle.lobes[k], &image = tangle.lobes[k + period];
    const double change = std::fabs(image.area - lobe.area);
    if (change > 0.1 * std::fabs(lobe.area)) {
      throw DataError("transport: the area of lobe " + std::to_string(k) + " is " + format_number(lobe.area) +
                      " and that of its image " + format_number(image.area) +
                      "; the formulas hold for maps that preserve area");
    }
    largest = std::max(largest, change / std::min(length(k), length(k + period)));
  }
  return largest;
}

}  // namespace

TransportOfCurves transport(const Tangle& tangle, int iterates) {
  if (iterates < 1) throw UsageError("transport takes at least one iterate");
  if (!tangle.boundary) throw DataError("transport: the manifolds do not cross");
  if (tangle.lobes.empty()) {
    // The last remark of the tangle says as much; one before it asks whether a curve is given from the other end.
    throw DataError("transport: the manifolds cross in one pip only, and enclose no lobe; " +
                    (tangle.remarks.size() > 1 ? tangle.remarks.front() : "try longer curves"));
  }
  if (!tangle.images.misfit.empty()) throw DataError("transport: " + tangle.images.misfit);
  if (tangle.images.period == 0) {
    throw DataError("transport: which pip is the image of which is not known (" + tangle.images.reason +
                    "); give the period");
  }
  Barrier barrier;
  barrier.tangle = &tangle;
  barrier.bip = tangle.boundary->bip;
  barrier.period = tangle.images.period;
  barrier.curve_error = point_error_of(tangle);
  TransportSeries series({barrier});
  TransportOfCurves result;
  result.regions = series.partition().regions();
  result.enclosed = enclosed_area(barrier);
  const Turnstile& turnstile = series.turnstiles()[0];
  result.flux12 = turnstile.flux12();
  result.flux21 = turnstile.flux21();
  result.lobe_area12 = turnstile.lobe_area12();
  result.lobe_area21 = turnstile.lobe_area21();
  while (static_cast<int>(result.steps.size()) < iterates && series.reaches_next()) {
    result.steps.push_back(series.next());
    compare_routes(result.agreement, series.partition(), result.steps.back());
  }
  if (static_cast<int>(result.steps.size()) < iterates) {
    // q, its images and its pre-images: n takes as many of them together.
    const int before = barrier.images_before(), after = barrier.images_after();
    const auto pips = [](int from, int to) {
      return "from f^" + std::to_string(from) + "(q) to f^" + std::to_string(to) + "(q)";
    };
    result.limit = "the curves show the images of the bip q " + pips(-before, after) +
                   ", and n takes n of them beside q"
                   "; longer curves, U and S both, show more";
  }
  result.remarks = tangle.remarks;
  const Point u = tangle.u().points.front(), s = tangle.s().points.front();
  if (distance(u, s) > 1e-6 * distance(u, tangle.pips[barrier.bip].at)) {
    result.remarks.push_back("U begins at " + format_point(u) + ", S at " + format_point(s) +
                             "; the boundary goes from the one to the other " +
                             (tangle.closure.empty() ? "straight" : "along the path given") +
                             ", which the map is taken to keep, and of a plane that repeats itself one period is seen; "
                             "with the equations of the map, as a system, neither is assumed");
  }
  if (const std::string remark = remark_on_closure(barrier); !remark.empty()) result.remarks.push_back(remark);
  return result;
}

}  // namespace lober
