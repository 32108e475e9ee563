#include "cli/tangle/tangle_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/program/log.hpp"

namespace lober::cli {

NamedCurve read_manifold(const std::string& spec, bool reverse) {
  NamedCurve input = read_curve(spec, false);
  if (reverse) std::reverse(input.curve.points.begin(), input.curve.points.end());
  return input;
}

Tangle tangle_of(const NamedCurve& u, const NamedCurve& s, const TangleOptions& options) {
  try {
    Tangle result = tangle(OpenCurve::borrow(u.curve.points), OpenCurve::borrow(s.curve.points), options);
    for (const std::string& remark : result.remarks) log_warning(fmt::format("warning: {}", remark));
    return result;
  } catch (const NotSimpleError& error) {
    const bool first = error.curve == 1;
    throw DataError(
        fmt::format("{}: {} crosses or touches itself: segments {} and {} meet at ({}, {}) (lober tangle "
                    "--no-check-simple takes such curves)",
                    spec_of(first ? u : s), first ? "U" : "S", error.segment1, error.segment2, error.at.x, error.at.y));
  }
}

std::vector<Point> pips_of(const Tangle& tangle) {
  std::vector<Point> points;
  points.reserve(tangle.pips.size());
  for (const Pip& pip : tangle.pips) points.push_back(pip.at);
  return points;
}

double discretisation(const TangleReport& report, std::size_t lobe) {
  return report.options.smooth ? report.result.lobes[lobe].smooth_error : report.shapes[lobe].discretisation;
}

TangleErrors errors_of(const TangleReport& report) {
  const Tangle& result = report.result;
  TangleErrors errors;
  for (std::size_t k = 0; k < result.lobes.size(); ++k) {
    const Lobe& lobe = result.lobes[k];
    errors.lobe_rounding = std::max(errors.lobe_rounding, result.rounding(lobe.area));
    errors.lobe_discretisation = std::max(errors.lobe_discretisation, discretisation(report, k));
    errors.split = std::max(errors.split, std::fabs(std::fabs(lobe.area) - lobe.inside - lobe.outside));
  }
  if (result.boundary) {
    errors.boundary_rounding = result.rounding(result.boundary->area);
    errors.boundary_discretisation =
        report.options.smooth ? result.boundary->smooth_error : boundary_discretisation(result);
  }
  return errors;
}

Agreement agreement_of_images(const TangleReport& report) {
  Agreement agreement;
  const Tangle& result = report.result;
  if (result.images.given || result.images.period == 0) return agreement;
  for (std::size_t k = 0; k + result.images.period < result.lobes.size(); ++k) {
    const std::size_t image = k + result.images.period;
    const double area = result.lobes[k].area, next = result.lobes[image].area;
    agreement.compare(
        {"area of lobe " + std::to_string(k), "itself", "its image under the map, lobe " + std::to_string(image), area,
         next,
         result.rounding(area) + result.rounding(next) + discretisation(report, k) + discretisation(report, image)});
  }
  return agreement;
}

}  // namespace lober::cli
