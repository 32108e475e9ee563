#include "engine/dynamics/escape/regularising_curve.hpp"

#include <cmath>

#include "kernels/elementary.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// s w = I of the strip: its area is I log(multiplier) in units of both tangents, on the local section.
double product_of(const Flow& flow, const Section& section, const BottleneckTubes& tubes, double strip) {
  const LocalManifold &s = tubes.stable->local(), &w = tubes.unstable->local();
  const PeriodicOrbit& orbit = tubes.stable->orbit();
  double own = 1, far = 1;
  for (const ConjugatePair& pair : flow.conjugate_pairs()) {
    if (pair.q == orbit.local.chart_x) own = std::fabs(pair.factor);
    if (pair.q == section.chart_x) far = std::fabs(pair.factor);
  }
  return strip * far / (own * elementary::log(s.multiplier) * std::fabs(cross(s.tangent, w.tangent)));
}

}  // namespace

RegularisingCurve::RegularisingCurve(const Flow& flow, const Section& section, const BottleneckTubes& tubes,
                                     double strip, const IntegrationOptions& integration)
    : flow_(flow),
      tubes_(tubes),
      product_(product_of(flow, section, tubes, strip)),
      log_multiplier_(elementary::log(tubes.stable->local().multiplier)),
      widest_(std::sqrt(product_ * tubes.stable->local().multiplier)) {
  const PeriodicOrbit& orbit = tubes.stable->orbit();
  const auto map = flow.section_map(orbit.local, orbit.energy, integration);
  const Point along_w = tubes.stable->local().tangent, along_s = tubes.unstable->local().tangent;
  const double sine = cross(along_w, along_s);
  const double w = static_cast<int>(tubes.out) * widest_ * elementary::exp(-log_multiplier_);
  const double s = product_ / w * static_cast<int>(tubes.in) * static_cast<int>(tubes.out);
  for (int round = 0; round < 8; ++round) {
    Point image = point(1);
    map->iterate({&image, 1}, 1);
    const Point r = image - point(0);
    const double off_w = elementary::log1p(cross(r, along_s) / sine / w),
                 off_s = elementary::log1p(cross(along_w, r) / sine / s);
    if (!std::isfinite(off_w) || !std::isfinite(off_s)) {
      throw DataError("the regularising curve of a tube could not be closed");
    }
    turn_ -= off_w / log_multiplier_;
    growth_ -= off_s + off_w;
  }
}

Point RegularisingCurve::point(double part) const {
  const LocalManifold &stable = tubes_.stable->local(), &unstable = tubes_.unstable->local();
  const double v = part * turn_, w = widest_ * elementary::exp((v - 1) * log_multiplier_);
  const double s = product_ * elementary::exp(growth_ * v) / w;
  const Point a = stable.at(static_cast<int>(tubes_.out) * w), b = unstable.at(static_cast<int>(tubes_.in) * s);
  return {a.x + b.x - unstable.saddle.x, a.y + b.y - unstable.saddle.y};
}

FlowState RegularisingCurve::state(double u) const {
  const PeriodicOrbit& orbit = tubes_.stable->orbit();
  const double part = u == 1 ? 1 : u - std::floor(u);
  return flow_.on_section(orbit.local, orbit.energy, point(part));
}

}  // namespace lober::detail
