#include "engine/dynamics/transport/tangles/splitting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/dynamics/maps/plane.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {
namespace {

// Positions on U within one iterate.
constexpr std::size_t samples_an_image = 64;
// Steps of Newton's method for the point of S opposite to one of U.
constexpr int max_newton_rounds = 12;
// A remainder along U beyond which S at the normal is not sought: it counts with the angle between them only.
constexpr double close_along = 1e-11;
// S may be this oblique to U, as the cosine between them.
constexpr double least_cosine = 0.2;

struct Opposite {
  ManifoldPosition u, s;
  double distance = 0;  // signed, positive to the left of U
};

// The point of S on the normal of U at x, from the time `time_s` on.
std::optional<Opposite> opposite(const PlanarMap& map, const LocalManifold& unstable, const LocalManifold& stable,
                                 ManifoldPosition u, ManifoldPosition s) {
  const MovingPoint on_u = point_on(map, unstable, u);
  const double speed = length(on_u.velocity);
  if (!(speed > 0) || !std::isfinite(speed)) return std::nullopt;
  const Point tangent{on_u.velocity.x / speed, on_u.velocity.y / speed};
  Point apart{};
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0; round < max_newton_rounds; ++round) {
    const MovingPoint on_s = point_on(map, stable, s);
    apart = {on_s.at.x - on_u.at.x, on_s.at.y - on_u.at.y};
    const double along = apart.x * tangent.x + apart.y * tangent.y;
    const double rate = on_s.velocity.x * tangent.x + on_s.velocity.y * tangent.y;
    if (!std::isfinite(along) || !(std::fabs(rate) > least_cosine * length(on_s.velocity))) return std::nullopt;
    if (std::fabs(along) <= close_along * (map.unit() + length(on_u.at))) break;
    // Newton's method has converged where it gains no more.
    if (round > 2 && !(std::fabs(along) < 0.5 * last)) break;
    // Errors are squared: about this would be left after this step.
    const double left = std::fabs(along) * (along / last) * (along / last);
    last = std::fabs(along);
    const double before = s.parameter;
    s.parameter -= along / rate;
    if (!(s.parameter * before > 0) || !(std::fabs(s.parameter) <= 4 * stable.reach)) return std::nullopt;
    s = normalised(stable, s);
    if (s.parameter == before) break;
    if (round > 0 && left <= close_along * (map.unit() + length(on_u.at))) {
      apart = {apart.x - on_s.velocity.x * along / rate, apart.y - on_s.velocity.y * along / rate};
      break;
    }
  }
  return Opposite{u, s, tangent.x * apart.y - tangent.y * apart.x};
}

// The size of the rough part of equidistant values: of sixth differences, which white noise enlarges by the square
// root of 924.
double roughness(const std::array<Opposite, samples_an_image + 1>& at) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k + 6 <= samples_an_image; ++k, ++count) {
    const auto d = [&](std::size_t i) { return at[k + i].distance; };
    const double difference = d(0) - 6 * d(1) + 15 * d(2) - 20 * d(3) + 15 * d(4) - 6 * d(5) + d(6);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(count) / 924);
}

}  // namespace

double time_of(const LocalManifold& local, ManifoldPosition position) {
  return position.images +
         elementary::log(std::fabs(position.parameter) / local.reach) / elementary::log(local.image().factor);
}

ManifoldPosition position_at(const LocalManifold& local, double time, double side) {
  const int images = std::max(0, static_cast<int>(std::ceil(time)));
  return {images, std::copysign(local.reach * elementary::power(local.image().factor, time - images), side)};
}

std::optional<Splitting> splitting(const PlanarMap& map, const LocalManifold& unstable, const LocalManifold& stable,
                                   ManifoldPosition u, ManifoldPosition s) {
  const double middle_u = time_of(unstable, u), middle_s = time_of(stable, s);
  // Sample k is at the time middle_u + (k + 1/2 - half) / samples: half a step off, so that the pip itself is not among
  // them. From the pip towards either end; each position on S is guessed from the one before.
  constexpr std::size_t half = samples_an_image / 2;
  std::array<Opposite, samples_an_image + 1> at;
  const auto walk = [&](std::size_t first, int direction) {
    double time_u = middle_u, time_s = middle_s, rate = -1;  // rate of time on S by time on U
    for (std::size_t k = first; k <= samples_an_image;
         k += static_cast<std::size_t>(direction)) {  // below 0 it is large
      const double next = middle_u + (static_cast<double>(k) + 0.5 - half) / samples_an_image;
      const auto found = opposite(map, unstable, stable, position_at(unstable, next, u.parameter),
                                  position_at(stable, time_s + rate * (next - time_u), s.parameter));
      if (!found) return false;
      const double now = time_of(stable, found->s);
      rate = (now - time_s) / (next - time_u);
      if (!(rate < 0)) return false;
      time_u = next;
      time_s = now;
      at[k] = *found;
    }
    return true;
  };
  if (!walk(half, 1) || !walk(half - 1, -1)) return std::nullopt;
  // One iterate outward along U is one iterate inward along S, or the search has strayed to another arc.
  if (std::fabs(time_of(stable, at[0].s) - time_of(stable, at[samples_an_image].s) - 1) > 0.05) return std::nullopt;

  Splitting result;
  result.defect = unstable.defect_across + stable.defect_across;
  result.noise = roughness(at);
  double lobe = 0;
  std::vector<double> lobes;
  for (std::size_t k = 0; k <= samples_an_image; ++k) {
    const double d = at[k].distance;
    result.largest = std::max(result.largest, std::fabs(d));
    if (k > 0 && d * at[k - 1].distance < 0) {
      ++result.zeros;
      result.near_zeros.emplace_back(at[k].u, at[k].s);
      lobes.push_back(lobe);
      lobe = 0;
    }
    lobe = std::max(lobe, std::fabs(d));
  }
  // The first and the last are parts of lobes.
  result.amplitude = result.largest;
  for (std::size_t k = 1; k < lobes.size(); ++k) result.amplitude = std::min(result.amplitude, lobes[k]);
  if (!lobes.empty()) result.amplitude = std::min(result.amplitude, std::max(lobes.front(), lobe));
  return result;
}

}  // namespace lober::detail
