#include "engine/dynamics/manifolds/outcome.hpp"

#include <algorithm>
#include <cmath>

namespace lober {

void append_finite(const Trace& trace, std::size_t first, Buffer<Point>& points, Buffer<double>& parameters,
                   std::vector<GrowthFlaw>& flaws) {
  const Samples& samples = trace.samples;
  // Samples without an image are next to flaws, so that from one flaw to the next all are taken.
  std::size_t next = first;
  const auto take_to = [&](std::size_t end) {
    if (next >= end) return;
    const auto from = static_cast<std::ptrdiff_t>(next), to = static_cast<std::ptrdiff_t>(end);
    points.insert(points.end(), samples.points.begin() + from, samples.points.begin() + to);
    parameters.insert(parameters.end(), samples.parameters.begin() + from, samples.parameters.begin() + to);
    next = end;
  };
  const auto finite = [&](std::size_t k) {
    return std::isfinite(samples.points[k].x) && std::isfinite(samples.points[k].y);
  };
  for (const GrowthFlaw& flaw : trace.flaws) {
    const std::size_t k = flaw.first;
    take_to(finite(k) ? k + 1 : k);
    next = std::max(next, finite(k + 1) ? k + 1 : k + 2);
    if (points.empty()) continue;  // nothing to join
    const GrowthFlaw here{points.size() - 1, 1, flaw.cause};
    if (!flaws.empty() && flaws.back().first + flaws.back().count > here.first) continue;  // the same gap
    if (!flaws.empty() && flaws.back().cause == here.cause && flaws.back().first + flaws.back().count == here.first) {
      ++flaws.back().count;
    } else {
      flaws.push_back(here);
    }
  }
  take_to(samples.points.size());
  cut_flaws(flaws, points.empty() ? 0 : points.size() - 1);
}

void cut_flaws(std::vector<GrowthFlaw>& flaws, std::size_t segments) {
  while (!flaws.empty() && flaws.back().first >= segments) flaws.pop_back();
  if (!flaws.empty()) flaws.back().count = std::min(flaws.back().count, segments - flaws.back().first);
}

}  // namespace lober
