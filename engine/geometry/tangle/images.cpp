#include "engine/geometry/tangle/images.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/text.hpp"

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

// Why it cannot be the period: no lobe has its image on the curves, or lobes change sides of U, which those of a map
// that preserves orientation do not, however it changes areas. Lobes count by their areas, since the signs of small
// ones may be wrong.
std::string misfit_of(const std::vector<Lobe>& lobes, std::size_t period) {
  const std::string given = "the period " + std::to_string(period) + " does not fit: ";
  if (period > lobes.size()) {
    return given + "the manifolds have " + std::to_string(lobes.size()) + (lobes.size() == 1 ? " lobe" : " lobes") +
           ", and no pip has its image among theirs; give a period of at most " + std::to_string(lobes.size());
  }
  double kept = 0, largest = 0;
  std::size_t example = 0;
  for (std::size_t k = 0; k + period < lobes.size(); ++k) {
    const double first = lobes[k].area, second = lobes[k + period].area;
    const double common = std::min(std::fabs(first), std::fabs(second));
    const bool same = (first > 0) == (second > 0);
    kept += same ? common : -common;
    if (same || common <= largest) continue;
    largest = common;
    example = k;
  }
  if (!(kept < 0)) return {};
  return given + "it makes lobe " + std::to_string(example + period) + ", of signed area " +
         format_number(lobes[example + period].area) + ", the image of lobe " + std::to_string(example) + ", of " +
         format_number(lobes[example].area) +
         "; a map that preserves orientation keeps the sign, so that the period of "
         "lobes that alternate is even";
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
  if (images.given) images.misfit = misfit_of(lobes, period);
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
