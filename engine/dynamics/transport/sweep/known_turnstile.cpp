#include "engine/dynamics/transport/sweep/known_turnstile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "engine/dynamics/transport/tangles/splitting.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr double images_apart = 1e-9, one_image = 1e-6;  // in images, as TangleGrowth has them

// Along U, in images: 0 where its parameter is 1, whatever the reach.
double time_of_orbit(const KnownTurnstile& known, std::size_t number) {
  const ManifoldPosition& u = known.orbits[number].u;
  return u.images + elementary::log(std::fabs(u.parameter)) / elementary::log(known.u.image().factor);
}

// About the same point of another manifold, whose reach and multiplier may differ, some images on.
ManifoldPosition moved(const LocalManifold& from, const LocalManifold& to, ManifoldPosition position, double images) {
  const double shift = elementary::log(from.reach / to.reach) / elementary::log(to.image().factor);
  return position_at(to, time_of(from, position) + shift + images, position.parameter);
}

// The image of q that is as far from one saddle as from the other, as a number of images: Newton's method is at its
// best there, and so is growing.
double images_to_the_middle(const KnownTurnstile& known) {
  const ConnectingOrbit& q = known.orbits.back();
  return std::round((time_of(known.s, q.s) - time_of(known.u, q.u)) / 2);
}

// f^-1(q) is not an orbit of its own; near a saddle Newton's method would find it less well.
ConnectingOrbit preimage(const PlanarMap& map, const KnownTurnstile& known, ConnectingOrbit q) {
  q.u = position_at(known.u, time_of(known.u, q.u) - 1, q.u.parameter);
  q.s = position_at(known.s, time_of(known.s, q.s) + 1, q.s.parameter);
  q.at = point_on(map, known.u, q.u).at;
  return q;
}

// Manifolds of different reach have no coefficients to compare.
ManifoldRate rate_of(const LocalManifold& from, const LocalManifold& to, double step) {
  if (step == 0 || from.reach != to.reach || from.coefficients.size() != to.coefficients.size()) return {};
  const auto rate = [step](Point a, Point b) { return Point{(b.x - a.x) / step, (b.y - a.y) / step}; };
  ManifoldRate result{rate(from.saddle, to.saddle), (to.multiplier - from.multiplier) / step, {}};
  for (std::size_t k = 0; k < to.coefficients.size(); ++k)
    result.coefficients.push_back(rate(from.coefficients[k], to.coefficients[k]));
  return result;
}

LocalManifold moved_on(const LocalManifold& from, const ManifoldRate& rate, double step) {
  LocalManifold result = from;
  if (rate.coefficients.empty()) return result;
  const auto add = [step](Point& at, Point by) { at = {at.x + step * by.x, at.y + step * by.y}; };
  add(result.saddle, rate.saddle);
  result.multiplier += step * rate.multiplier;
  for (std::size_t k = 0; k < result.coefficients.size(); ++k) add(result.coefficients[k], rate.coefficients[k]);
  return result;
}

constexpr double lost = std::numeric_limits<double>::infinity();

// Orbits that are not behind the one before are another pip's, and lost. False if q is.
bool order(KnownTurnstile& known) {
  const std::size_t last = known.orbits.size() - 1;
  double before = time_of_orbit(known, 0);
  for (std::size_t k = 1; k <= last; ++k) {
    if (known.is_lost(k)) continue;
    const double time = time_of_orbit(known, k);
    if (time > before + images_apart && (k == last || time < time_of_orbit(known, last) - images_apart)) {
      before = time;
    } else {
      if (k == last) return false;
      known.orbits[k].residual = lost;
    }
  }
  return true;
}

// Whether each orbit has moved by so little, in images along U, that it cannot be another pip's: by a quarter of what
// lies between it and the pips next to it, or, where they were lost, between pips at even distances. Newton's method
// converges to any of them.
bool are_the_same(const KnownTurnstile& known, const KnownTurnstile& before, double images) {
  constexpr double part_of_gap = 0.25;
  const std::size_t last = before.orbits.size() - 1;
  for (std::size_t k = 1; k <= last; ++k) {
    if (before.is_lost(k) || known.is_lost(k)) continue;
    const double here = time_of_orbit(before, k);
    double gap = 1 / static_cast<double>(last);
    const std::size_t next = k < last ? k + 1 : 1;
    if (!before.is_lost(k - 1) && !before.is_lost(next)) {
      // The one after the last is the image of the first one.
      const double after = time_of_orbit(before, next) + (k < last ? 0 : 1);
      gap = std::min(here - time_of_orbit(before, k - 1), after - here);
    }
    if (std::fabs(time_of_orbit(known, k) - here - images) > part_of_gap * gap) return false;
  }
  return true;
}

}  // namespace

std::optional<double> KnownTurnstile::difference() const {
  for (std::size_t k = 0; k < orbits.size(); ++k) {
    if (is_lost(k)) return std::nullopt;
  }
  const auto area = lobe_area_by_action(orbits[(orbits.size() - 1) / 2], orbits.back());
  return area ? std::optional(-*area) : std::nullopt;
}

double KnownTurnstile::error() const {
  return orbits[(orbits.size() - 1) / 2].action_error + orbits.back().action_error;
}

std::optional<std::size_t> KnownTurnstile::same_pip(const KnownTurnstile& other, std::size_t number) const {
  const double time = time_of_orbit(other, number);
  for (std::size_t k = 1; k < orbits.size(); ++k) {
    if (is_lost(k)) continue;
    const double images = time - time_of_orbit(*this, k);
    if (std::fabs(images - std::round(images)) <= one_image) return k;
  }
  return std::nullopt;
}

// U is grown to the pip and S to its pre-image. Their lengths go with the multipliers, and a point takes an image for
// each generation.
KnownBip KnownTurnstile::bip(std::size_t number) const {
  const ConnectingOrbit& orbit = orbits[number];
  const double on_u = time_of(u, orbit.u), on_s = time_of(s, orbit.s);
  const auto cost_of = [](const LocalManifold& local, double time) {
    const double to_end = std::max(time, 0.0);
    return local.reach * elementary::power(local.image().factor, to_end) * (1 + to_end);
  };
  double least = std::numeric_limits<double>::infinity();
  int best = 0;
  for (const int images : {0, 1, -1, 2, -2}) {
    const double cost = cost_of(u, on_u + images) + cost_of(s, on_s + 1 - images);
    if (cost >= least) continue;
    least = cost;
    best = images;
  }
  return {u, s, position_at(u, on_u + best, orbit.u.parameter), position_at(s, on_s - best, orbit.s.parameter)};
}

KnownTurnstile known_turnstile(const ManifoldTangle& found) {
  return {found.local_u, found.local_s, {}, {}, found.orbits};
}

std::optional<KnownTurnstile> continued_turnstile(const PlanarMap& map, const Connection& connection,
                                                  const KnownTurnstile& from, double step) {
  const LocalManifold near_u = moved_on(from.u, from.rate_u, step), near_s = moved_on(from.s, from.rate_s, step);
  Connection between = connection;
  between.from = near_u.saddle;
  between.to = near_s.saddle;
  KnownTurnstile known;
  std::tie(known.u, known.s) = local_manifolds(map, between, &near_u, &near_s);
  known.rate_u = rate_of(from.u, known.u, step);
  known.rate_s = rate_of(from.s, known.s, step);
  const double images = images_to_the_middle(from);
  const std::size_t last = from.orbits.size() - 1;
  known.orbits.resize(last + 1);
  for (std::size_t k = last; k > 0; --k) {
    const ConnectingOrbit& orbit = from.orbits[k];
    try {
      known.orbits[k].residual = lost;
      if (from.is_lost(k)) continue;
      known.orbits[k] = connecting_orbit(map, known.u, known.s, moved(from.u, known.u, orbit.u, images),
                                         moved(from.s, known.s, orbit.s, -images));
    } catch (const DataError&) {
      if (k == last) return std::nullopt;
    }
  }
  known.orbits.front() = preimage(map, known, known.orbits.back());
  return are_the_same(known, from, images) && order(known) ? std::optional(std::move(known)) : std::nullopt;
}

}  // namespace lober::detail
