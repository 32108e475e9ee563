#include "engine/dynamics/manifolds/outcome.hpp"

#include <algorithm>
#include <cmath>

namespace lober::detail {

void append_finite(const Trace& trace, std::size_t first, double sign, Buffer<Point>& points,
                   Buffer<double>& parameters, std::vector<GrowthDiagnostic>& diagnostics) {
  const Samples& samples = trace.samples;
  // Samples without an image are next to diagnostics, so that from one diagnostic to the next all are taken.
  std::size_t next = first;
  const auto take_to = [&](std::size_t end) {
    if (next >= end) return;
    const std::size_t at = points.size();
    points.resize(at + end - next);
    parameters.resize(at + end - next);
    std::copy(&samples.points[next], &samples.points[end - 1] + 1, &points[at]);
    std::transform(&samples.parameters[next], &samples.parameters[end - 1] + 1, &parameters[at],
                   [sign](double parameter) { return sign * parameter; });
    next = end;
  };
  const auto finite = [&](std::size_t k) {
    return std::isfinite(samples.points[k].x) && std::isfinite(samples.points[k].y);
  };
  for (const GrowthDiagnostic& diagnostic : trace.diagnostics) {
    const std::size_t k = diagnostic.first;
    take_to(finite(k) ? k + 1 : k);
    next = std::max(next, finite(k + 1) ? k + 1 : k + 2);
    if (points.empty()) continue;  // nothing to join
    const GrowthDiagnostic here{points.size() - 1, 1, diagnostic.cause};
    if (!diagnostics.empty() && diagnostics.back().first + diagnostics.back().count > here.first)
      continue;  // the same gap
    if (!diagnostics.empty() && diagnostics.back().cause == here.cause &&
        diagnostics.back().first + diagnostics.back().count == here.first) {
      ++diagnostics.back().count;
    } else {
      diagnostics.push_back(here);
    }
  }
  take_to(samples.points.size());
  cut_diagnostics(diagnostics, points.empty() ? 0 : points.size() - 1);
}

void cut_diagnostics(std::vector<GrowthDiagnostic>& diagnostics, std::size_t segments) {
  while (!diagnostics.empty() && diagnostics.back().first >= segments) diagnostics.pop_back();
  if (!diagnostics.empty())
    diagnostics.back().count = std::min(diagnostics.back().count, segments - diagnostics.back().first);
}

}  // namespace lober::detail
