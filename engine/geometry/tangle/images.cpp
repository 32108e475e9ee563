#include "engine/geometry/tangle/images.hpp"

#include <algorithm>
#include <cmath>

namespace lober {
using namespace detail;
namespace {

double mean_area(const std::vector<Lobe>& lobes) {
  double sum = 0;
  for (const Lobe& lobe : lobes) sum += std::fabs(lobe.area);
  return sum / static_cast<double>(lobes.size());
}

// The largest change of signed area from a lobe to that `period` further on.
double largest_change(const std::vector<Lobe>& lobes, std::size_t period) {
  double largest = 0;
  for (std::size_t k = 0; k + period < lobes.size(); ++k) {
    largest = std::max(largest, std::fabs(lobes[k + period].area - lobes[k].area));
  }
  return largest;
}

std::uint32_t infer_period(const std::vector<Lobe>& lobes, double mean, std::string& reason) {
  if (lobes.size() < 3) {
    reason = "fewer than three lobes, so no lobe is seen together with its image";
    return 0;
  }
  // A long period has to be seen more than once: areas that differ as they like are alike now and then.
  constexpr std::size_t short_period = 4, most = 64;
  for (std::size_t period = 2; period < std::min(lobes.size(), most); period += 2) {
    if (period > short_period && 2 * period > lobes.size()) break;
    if (largest_change(lobes, period) <= repeat_tolerance * mean) return static_cast<std::uint32_t>(period);
  }
  reason = "the signed areas of the lobes do not repeat";
  return 0;
}

}  // namespace

std::string text(const LobeLabel& label) {
  if (label.from == 0) return {};
  return "L" + std::to_string(label.from) + std::to_string(label.to) + "(" + std::to_string(label.n) + ")";
}

Images detail::find_images(const Tangle& tangle, std::uint32_t given_period) {
  const std::vector<Lobe>& lobes = tangle.lobes;
  Images images;
  images.labels.resize(lobes.size());
  if (lobes.empty()) {
    images.reason = "no lobe";
    return images;
  }
  const double mean = mean_area(lobes);
  images.given = given_period != 0;
  images.period = images.given ? given_period : infer_period(lobes, mean, images.reason);
  if (images.period == 0) return images;
  const std::size_t period = images.period;
  if (period < lobes.size()) {
    images.compared = lobes.size() - period;
    images.area_change = largest_change(lobes, period) / mean;
  }
  for (std::size_t k = 0; k + period <= lobes.size(); ++k) {
    double sum = 0;
    for (std::size_t m = k; m < k + period; ++m) sum += lobes[m].area;
    images.turnstile_sum = std::max(images.turnstile_sum, std::fabs(sum) / mean);
  }

  // A turnstile lobe, before the bip, lies inside if its left is the boundary's left: next it will be outside.
  const std::size_t bip = tangle.boundary->bip;
  // On which side of U a lobe lies follows from how the pip before it crosses; areas tell it too, but not far from the
  // bip, where the curves may be coarse.
  double sides = 0;
  for (std::size_t k = bip - std::min(bip, period); k < std::min(bip + period, lobes.size()); ++k) {
    sides += lobes[k].area * tangle.pips[k].rho;
  }
  for (std::size_t k = 0; k < lobes.size(); ++k) {
    const int rho = tangle.pips[k].rho;
    const int orientation = rho == 0 || sides == 0 ? lobes[k].orientation() : (sides * rho > 0 ? 1 : -1);
    const bool leaves = orientation == tangle.boundary->orientation;
    const auto turns = static_cast<int>((bip + lobes.size() * period - 1 - k) / period - lobes.size());
    images.labels[k] = {leaves ? 1 : 2, leaves ? 2 : 1, turns + 1};
  }
  if (bip >= period) {
    images.turnstile_begin = bip - period;
    images.turnstile_end = bip;
    for (std::size_t k = images.turnstile_begin; k < bip; ++k) {
      (images.labels[k].from == 1 ? images.lobe_area12 : images.lobe_area21) += std::fabs(lobes[k].area);
    }
  }
  return images;
}

}  // namespace lober
