#include "lober/dynamics/connecting_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "engine/base/text.hpp"
#include "engine/dynamics/manifolds/directed_orbit.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

// The points of an orbit on one manifold from `position` towards the saddle, until they are the saddle: one step of the
// map (forward or back) apart.
std::vector<Point> towards_saddle(const PlanarMap& map, const LocalManifold& local, ManifoldPosition position) {
  const LocalManifold::Image image = local.image();
  const int direction = image.steps > 0 ? 1 : -1, stride = image.steps * direction;
  std::vector<Point> points;
  // Goes from P(parameter) outwards to the point itself.
  Point at = local.at(position.parameter);
  std::vector<Point> outwards{at};
  for (int k = 0; k < position.images * stride; ++k) {
    map.iterate({&at, 1}, direction);
    outwards.push_back(at);
  }
  points.assign(outwards.rbegin(), outwards.rend());
  // Goes inwards along P, where errors shrink.
  constexpr int max_images = 4000;
  constexpr double gone = 1e-22;
  double s = position.parameter;
  for (int k = 0; k < max_images && std::fabs(s) > gone * local.reach; ++k) {
    s /= image.factor;
    at = local.at(s);
    std::vector<Point> between{at};
    for (int j = 1; j < stride; ++j) {
      map.iterate({&at, 1}, direction);
      between.push_back(at);
    }
    points.insert(points.end(), between.rbegin(), between.rend());
  }
  return points;
}

// The sum of L along the points, each one step from the next, less that of the saddle's own orbit. `points[0]` is where
// both halves of the orbit meet.
std::optional<long double> half_action(const PlanarMap& map, const LocalManifold& local, std::span<const Point> points,
                                       double& error) {
  const double unit = map.unit();
  const bool forward = local.steps > 0;  // from the saddle outwards; the points run inwards
  const auto period = static_cast<std::size_t>(std::abs(local.steps));
  const auto step = [&](Point nearer, Point farther) {
    return forward ? map.action(nearer, farther) : map.action(farther, nearer);
  };
  // The saddle's own orbit, outwards.
  std::vector<Point> saddle{local.saddle};
  for (std::size_t k = 1; k < period; ++k) {
    Point next = saddle.back();
    map.iterate({&next, 1}, forward ? 1 : -1);
    saddle.push_back(next);
  }
  std::vector<long double> own(period);
  for (std::size_t k = 0; k < period; ++k) {
    const std::optional<long double> action = step(saddle[k], saddle[(k + 1) % period]);
    if (!action) return std::nullopt;
    own[k] = *action;
  }
  long double sum = 0;
  const std::size_t last = points.size() - 1;  // where the orbit is in step with the saddle
  for (std::size_t k = last; k-- > 0;) {
    const std::optional<long double> action = step(points[k + 1], points[k]);
    if (!action) return std::nullopt;
    const long double more = *action - own[(last - k - 1) % period];
    sum += more;
    // An error of x by its share of unit + |x| makes one of y dx, which may be more than what is left of it in L.
    const double of_points = std::fabs(points[k].y) * (unit + std::fabs(points[k].x));
    error += map.action_accuracy() * std::max(unit * unit + static_cast<double>(std::fabs(*action)), of_points);
  }
  return sum;
}

// Newton's method for the point that both have, until it gains no more.
DirectedOrbit closest(const PlanarMap& map, const LocalManifold& unstable, const LocalManifold& stable,
                      ManifoldPosition u, ManifoldPosition s) {
  u = normalised(unstable, u);
  s = normalised(stable, s);
  DirectedOrbit best;
  best.orbit.residual = std::numeric_limits<double>::infinity();
  int without_gain = 0;
  constexpr int max_rounds = 40;
  for (int round = 0; round < max_rounds && without_gain < 3; ++round) {
    const MovingPoint on_u = point_on(map, unstable, u), on_s = point_on(map, stable, s);
    const Point apart{on_s.at.x - on_u.at.x, on_s.at.y - on_u.at.y};
    const double residual = std::hypot(apart.x, apart.y);
    if (!std::isfinite(residual)) break;
    const double sine = on_u.velocity.x * on_s.velocity.y - on_u.velocity.y * on_s.velocity.x;
    if (residual < best.orbit.residual) {
      best = {{on_u.at, u, s, residual, {}, 0}, sine > 0};
      without_gain = 0;
    } else {
      ++without_gain;
    }
    if (sine == 0) break;
    u.parameter += (apart.x * on_s.velocity.y - apart.y * on_s.velocity.x) / sine;
    s.parameter += (apart.x * on_u.velocity.y - apart.y * on_u.velocity.x) / sine;
    u = normalised(unstable, u);
    s = normalised(stable, s);
  }
  return best;
}

// The residual left by rounding and the errors of integration is far below the distance from the saddle.
bool is_met(const ConnectingOrbit& orbit, const LocalManifold& unstable) {
  return orbit.residual <= 1e-6 * distance(orbit.at, unstable.saddle);
}

// The change of the action by the residual: the next point of the orbit is off by the residual times the stretching of
// an iterate, and the action is stationary.
double action_of_residual(const ConnectingOrbit& orbit, const LocalManifold& unstable, const LocalManifold& stable) {
  const double off = orbit.residual * std::max(std::fabs(unstable.multiplier), std::fabs(stable.multiplier));
  return off * off;
}

// Next to the one saddle the other manifold has come a long way, and its errors with it: more than the distance from
// the saddle, where one iterate stretches far. The point of the same orbit half-way, `images` on, is seen by
// both.
int images_half_way(const LocalManifold& unstable, const LocalManifold& stable, ManifoldPosition u,
                    ManifoldPosition s) {
  return unstable.image().steps == -stable.image().steps ? std::max((s.images - u.images + 1) / 2, 0) : 0;
}

}  // namespace

MovingPoint point_on(const PlanarMap& map, const LocalManifold& local, ManifoldPosition position) {
  Matrix2 d;
  const Point start = local.at(position.parameter), v = local.slope(position.parameter);
  const Point at = map.iterate_with_derivative(start, position.images * local.image().steps, d);
  return {at, {d.xx * v.x + d.xy * v.y, d.yx * v.x + d.yy * v.y}};
}

ManifoldPosition normalised(const LocalManifold& local, ManifoldPosition position) {
  const double factor = local.image().factor;
  while (std::fabs(position.parameter) > local.reach) {
    position.parameter /= factor;
    ++position.images;
  }
  while (position.images > 0 && std::fabs(position.parameter) * factor <= local.reach) {
    position.parameter *= factor;
    --position.images;
  }
  return position;
}

ManifoldPosition position_on(const GrownManifold& grown, const LocalManifold& local, Position position) {
  const auto generation_of = [&](std::size_t vertex) {
    const auto after = std::upper_bound(grown.generation_begin.begin(), grown.generation_begin.end(), vertex);
    return static_cast<int>(after - grown.generation_begin.begin()) - 1;
  };
  const std::size_t first = position.segment, second = std::min(first + 1, grown.parameters.size() - 1);
  const int generation = generation_of(first), next = generation_of(second);
  const double factor = local.image().factor;
  const double from = grown.parameters[first];
  const double to = grown.parameters[second] * (next > generation ? elementary::power(factor, next - generation) : 1);
  return normalised(local, {generation, from + position.t * (to - from)});
}

DirectedOrbit detail::directed_orbit(const PlanarMap& map, const LocalManifold& unstable, const LocalManifold& stable,
                                     ManifoldPosition u, ManifoldPosition s) {
  u = normalised(unstable, u);
  s = normalised(stable, s);
  DirectedOrbit directed = closest(map, unstable, stable, u, s);
  ConnectingOrbit& best = directed.orbit;
  int on = 0;  // images from the point that is asked for to the one that is met
  constexpr double sharp = 1e-14;
  if (!is_met(best, unstable) || action_of_residual(best, unstable, stable) > sharp * map.unit() * map.unit()) {
    on = images_half_way(unstable, stable, u, s);
    std::optional<DirectedOrbit> half_way;
    if (on > 0) half_way = closest(map, unstable, stable, {u.images + on, u.parameter}, {s.images - on, s.parameter});
    const bool better = half_way && is_met(half_way->orbit, unstable) &&
                        (!is_met(best, unstable) || half_way->orbit.residual < best.residual);
    if (better) {
      directed = *half_way;
    } else if (on = 0; !is_met(best, unstable)) {
      throw DataError("no orbit between the saddles was found near " + format_point(best.at) +
                      ": the manifolds touch there, do not cross, or are not resolved");
    }
  }
  std::vector<Point> before = towards_saddle(map, unstable, best.u);
  std::vector<Point> after = towards_saddle(map, stable, best.s);
  after[0] = before[0];  // one point, so that the action is stationary in it
  if (on > 0) {
    const auto images = static_cast<std::size_t>(on) * static_cast<std::size_t>(unstable.image().steps);
    if (images + 1 >= before.size()) throw DataError("the orbit between the saddles begins in the saddle itself");
    const auto begin = before.begin(), at = begin + static_cast<std::ptrdiff_t>(images);
    after.insert(after.begin(), std::reverse_iterator(at + 1), std::reverse_iterator(begin + 1));
    before.erase(begin, at);
    best.at = before[0];
    best.u.images -= on;
    best.s.images += on;
    for (; best.u.images < 0; ++best.u.images) best.u.parameter /= unstable.image().factor;
  }
  const auto to_here = half_action(map, unstable, before, best.action_error);
  const auto from_here = half_action(map, stable, after, best.action_error);
  if (to_here && from_here) best.action = *to_here + *from_here;
  best.action_error += action_of_residual(best, unstable, stable);
  return directed;
}

ConnectingOrbit connecting_orbit(const PlanarMap& map, const LocalManifold& unstable, const LocalManifold& stable,
                                 ManifoldPosition u, ManifoldPosition s) {
  return directed_orbit(map, unstable, stable, u, s).orbit;
}

std::optional<double> lobe_area_by_action(const ConnectingOrbit& first, const ConnectingOrbit& second) {
  if (!first.action || !second.action) return std::nullopt;
  return static_cast<double>(*first.action - *second.action);
}

}  // namespace lober
