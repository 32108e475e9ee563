#include "engine/dynamics/fixed_points/index.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

// Where z is on its way round the box, for 0 <= t <= 4, counter-clockwise from the lower left corner.
Point on_edge(const Rectangle& box, double t) {
  const auto between = [](double low, double high, double f) { return low * (1 - f) + high * f; };
  if (t <= 1) return {between(box.min_x, box.max_x, t), box.min_y};
  if (t <= 2) return {box.max_x, between(box.min_y, box.max_y, t - 1)};
  if (t <= 3) return {between(box.max_x, box.min_x, t - 2), box.max_y};
  return {box.min_x, between(box.max_y, box.min_y, t - 3)};
}

// For 0 <= t <= 4; closed to the bit.
Point on_circle(Point centre, double radius, double t) {
  const double angle = t == 4 ? 0 : t * std::numbers::pi / 2;
  return {centre.x + radius * elementary::cos(angle), centre.y + radius * elementary::sin(angle)};
}

// A point of the path and its displacement.
struct Sample {
  double t;
  Point gap;
  bool certain;  // more than rounding
};

double turn(Point a, Point b) {
  return elementary::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

// Samples of path(t), 0 <= t <= 4, are put in until neighbouring displacements differ by less than `most` in direction;
// none where that takes more than `left` images, the path goes through a point, or the map is not continuous there.
template <typename Path>
std::optional<int> turns_along(const PlanarMap& map, const Path& path, std::size_t first_samples,
                               const FixedPointOptions& options, double left) {
  constexpr double most = 0.5;
  const double noise = noise_of(map);
  const auto displaced = [&](const std::vector<double>& ts) {
    std::vector<Point> points(ts.size());
    for_each_block(ts.size(), std::max(std::size_t{64}, map.batch()), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) points[k] = path(ts[k]);
      map.iterate(std::span(points).subspan(begin, end - begin), options.period);
    });
    std::vector<Sample> samples(ts.size());
    for (std::size_t k = 0; k < ts.size(); ++k) {
      const Point z = path(ts[k]), gap = gap_between(z, points[k], options);
      samples[k] = {ts[k], gap, is_finite(gap) && length(gap) > noise * size_at(z, options.extent)};
    }
    return samples;
  };
  const auto enough = static_cast<double>(first_samples);
  if (left < enough) return std::nullopt;
  std::vector<double> ts;
  for (std::size_t k = 0; k <= first_samples; ++k) ts.push_back(4 * static_cast<double>(k) / enough);
  std::vector<Sample> samples = displaced(ts);
  while (true) {
    if (!std::all_of(samples.begin(), samples.end(), [](const Sample& s) { return s.certain; })) return std::nullopt;
    ts.clear();
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      if (std::fabs(turn(samples[k].gap, samples[k + 1].gap)) <= most) continue;
      const double middle = 0.5 * (samples[k].t + samples[k + 1].t);
      if (middle == samples[k].t || middle == samples[k + 1].t) return std::nullopt;
      ts.push_back(middle);
    }
    if (ts.empty()) break;
    left -= static_cast<double>(ts.size());
    if (left < enough) return std::nullopt;
    const std::vector<Sample> more = displaced(ts);
    std::vector<Sample> all(samples.size() + more.size());
    std::merge(samples.begin(), samples.end(), more.begin(), more.end(), all.begin(),
               [](const Sample& a, const Sample& b) { return a.t < b.t; });
    samples = std::move(all);
  }
  double sum = 0;
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) sum += turn(samples[k].gap, samples[k + 1].gap);
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

}  // namespace

std::optional<int> detail::index_of_edge(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options,
                                         double an_image, const SearchAllowance& allowance) {
  const std::size_t samples = by_formula(map) ? 32768 : 2048;
  constexpr double max_samples = 4e6;  // those of a formula count as no work
  const double images = an_image > 0 ? allowance.part(0.25) / an_image : max_samples;
  return turns_along(
      map, [&](double t) { return on_edge(box, t); }, samples, options, std::min(images, max_samples));
}

std::optional<int> detail::index_around(const PlanarMap& map, Point centre, double most,
                                        const FixedPointOptions& options) {
  constexpr std::size_t samples = 32;
  constexpr double max_samples = 4096;
  double radius = 1e-6 * size_at(centre, options.extent);
  while (radius <= most) {
    const std::optional<int> turns = turns_along(
        map, [&](double t) { return on_circle(centre, radius, t); }, samples, options, max_samples);
    if (turns) return turns;
    radius *= 4;
  }
  return std::nullopt;
}

int index_of(const FixedPoint& point, int period) {
  if (period < 1 || period % point.period != 0) {
    throw UsageError("the period of an index has to be a multiple of the point's");
  }
  // (1 - a) (1 - b) and what (1 - a^n) (1 - b^n) is times that: near roots of unity rounding has a say in the latter.
  std::complex<double> product = 1, times = 1;
  for (const std::complex<double>& eigenvalue : point.multipliers) {
    std::complex<double> sum = 1, power = 1;
    for (int k = 1; k < period / point.period; ++k) sum += (power *= eigenvalue);
    product *= 1.0 - eigenvalue;
    times *= sum;
  }
  if (std::abs(times.real()) <= 1e-7) return 0;
  const double all = product.real() * times.real();
  return all > 0 ? 1 : all < 0 ? -1 : 0;
}

}  // namespace lober
