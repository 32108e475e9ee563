#include "engine/dynamics/transport/sweep/known_turnstile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/dynamics/manifolds/directed_orbit.hpp"
#include "engine/dynamics/transport/tangles/splitting.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr double images_apart = 1e-9, one_image = 1e-6;  // in images, as TangleGrowth has them

// Where an orbit is on both manifolds, in images.
struct OrbitTime {
  double u, s;
};

double log_factor(const LocalManifold& local) {
  return elementary::log(local.image().factor);
}

// Where a position is, in images: 0 at the end of the local manifold if that had this reach. Manifolds of other reach,
// and of maps nearby, are compared by one.
double time_by(double reach, double log_factor, ManifoldPosition position) {
  return position.images + elementary::log(std::fabs(position.parameter) / reach) / log_factor;
}

OrbitTime time_of_orbit(const KnownManifolds& on, const ConnectingOrbit& orbit, const KnownManifolds& reaches) {
  return {time_by(reaches.u.local.reach, log_factor(on.u.local), orbit.u),
          time_by(reaches.s.local.reach, log_factor(on.s.local), orbit.s)};
}
OrbitTime time_of_orbit(const KnownTurnstile& known, std::size_t number) {
  return time_of_orbit(known.on, known.orbits[number], known.on);
}

// The position at that time.
ManifoldPosition position_by(double reach, const LocalManifold& local, double time, double side) {
  return position_at(local, time + elementary::log(reach / local.reach) / log_factor(local), side);
}

// The times of an orbit when the parameter is `step` from that of `from`, by what is known there and before.
OrbitTime expected(const KnownTurnstile& from, std::size_t number, double step, double images) {
  const OrbitTime here = time_of_orbit(from, number);
  std::vector<double> offsets{0};
  std::vector<OrbitTime> times{here};
  for (const KnownTurnstile::Past& past : from.past) {
    if (std::fabs(past.offset) < shortest_past * std::fabs(step)) break;
    offsets.push_back(past.offset);
    times.push_back({time_by(from.on.u.local.reach, past.u.log_factor, past.u.at[number]),
                     time_by(from.on.s.local.reach, past.s.log_factor, past.s.at[number])});
  }
  const std::vector<double> weights = interpolation_weights(offsets, step);
  OrbitTime time{here.u + images, here.s - images};
  for (std::size_t k = 1; k < offsets.size(); ++k) {
    time.u += weights[k] * (times[k].u - here.u);
    time.s += weights[k] * (times[k].s - here.s);
  }
  return time;
}

// The image of q that is as far from one saddle as from the other, as a number of images: Newton's method is at its
// best there, and so is growing.
int images_to_the_middle(const KnownTurnstile& known) {
  const ConnectingOrbit& q = known.orbits.back();
  return static_cast<int>(std::round((time_of(known.on.s.local, q.s) - time_of(known.on.u.local, q.u)) / 2));
}

// f^-1(q) is not an orbit of its own; near a saddle Newton's method would find it less well.
ConnectingOrbit preimage(const PlanarMap& map, const KnownManifolds& on, ConnectingOrbit q) {
  const LocalManifold &u = on.u.local, &s = on.s.local;
  q.u = position_at(u, time_of(u, q.u) - 1, q.u.parameter);
  q.s = position_at(s, time_of(s, q.s) + 1, q.s.parameter);
  q.at = point_on(map, u, q.u).at;
  return q;
}

// The past of a turnstile that is `step` and some images on from `from`.
std::vector<KnownTurnstile::Past> past_of(const KnownTurnstile& from, double step, int images) {
  if (step == 0) return {};
  std::vector<KnownTurnstile::Past> result(1);
  KnownTurnstile::Past& before = result[0];
  before = {0, {log_factor(from.on.u.local), {}}, {log_factor(from.on.s.local), {}}};
  for (const ConnectingOrbit& orbit : from.orbits) {
    before.u.at.push_back(orbit.u);
    before.s.at.push_back(orbit.s);
  }
  for (const KnownTurnstile::Past& past : from.past) {
    if (result.size() + 1 == values_to_extrapolate) break;
    if (lies_apart(past.offset, step)) result.push_back(past);
  }
  for (KnownTurnstile::Past& past : result) {
    past.offset -= step;
    for (ManifoldPosition& position : past.u.at) position.images += images;
    for (ManifoldPosition& position : past.s.at) position.images -= images;
  }
  return result;
}

constexpr double lost = std::numeric_limits<double>::infinity();

// Orbits that are not behind the one before are another pip's, and lost. False if q is.
bool order(KnownTurnstile& known) {
  const std::size_t last = known.orbits.size() - 1;
  double before = time_of_orbit(known, 0).u;
  for (std::size_t k = 1; k <= last; ++k) {
    if (known.is_lost(k)) continue;
    const double time = time_of_orbit(known, k).u;
    if (time > before + images_apart && (k == last || time < time_of_orbit(known, last).u - images_apart)) {
      before = time;
    } else {
      if (k == last) return false;
      known.orbits[k].residual = lost;
    }
  }
  return true;
}

// Whether each orbit is so near to where it was expected, in images along U, that it cannot be another pip's, to any of
// which Newton's method may converge: off by a quarter of what lies between it and the pips next to it, or, where they
// were lost, between pips at even distances. Where it has moved by more than that in all, the manifolds have to cross
// there the same way as before, which they do not at the pips next to it.
bool are_the_same(const KnownTurnstile& known, const KnownTurnstile& before, double step, double images) {
  constexpr double part_of_gap = 0.25;
  const std::size_t last = before.orbits.size() - 1;
  for (std::size_t k = 1; k <= last; ++k) {
    if (before.is_lost(k) || known.is_lost(k)) continue;
    const double here = time_of_orbit(before, k).u;
    double gap = 1 / static_cast<double>(last);
    const std::size_t next = k < last ? k + 1 : 1;
    if (!before.is_lost(k - 1) && !before.is_lost(next)) {
      // The one after the last is the image of the first one.
      const double after = time_of_orbit(before, next).u + (k < last ? 0 : 1);
      gap = std::min(here - time_of_orbit(before, k - 1).u, after - here);
    }
    const double there = time_of_orbit(known.on, known.orbits[k], before.on).u;
    if (std::fabs(there - expected(before, k, step, images).u) > part_of_gap * gap) return false;
    const bool has_moved = std::fabs(there - here - images) > part_of_gap * gap;
    if (has_moved && (before.to_left.empty() || known.to_left[k] != before.to_left[k])) return false;
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
  const double time = time_of_orbit(other.on, other.orbits[number], on).u;
  for (std::size_t k = 1; k < orbits.size(); ++k) {
    if (is_lost(k)) continue;
    const double images = time - time_of_orbit(*this, k).u;
    if (std::fabs(images - std::round(images)) <= one_image) return k;
  }
  return std::nullopt;
}

// U is grown to the pip and S to its pre-image. Their lengths go with the multipliers, and a point takes an image for
// each generation.
KnownStart KnownTurnstile::start(std::size_t number) const {
  const LocalManifold &u = on.u.local, &s = on.s.local;
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
  KnownStart start{
      u,
      s,
      KnownBip{position_at(u, on_u + best, orbit.u.parameter), position_at(s, on_s - best, orbit.s.parameter)},
      {}};
  for (std::size_t k = 1; k < orbits.size(); ++k) {
    if (!is_lost(k)) start.orbits.push_back(orbits[k]);
  }
  return start;
}

KnownTurnstile known_turnstile(const ManifoldTangle& found) {
  return {{{found.local_u, {}, {}, 0, 0}, {found.local_s, {}, {}, 0, 0}}, found.orbits, {}, {}};
}

std::optional<KnownTurnstile> continued_turnstile(const PlanarMap& map, KnownManifolds manifolds,
                                                  const KnownTurnstile& from, double step) {
  KnownTurnstile known{std::move(manifolds), {}, {}, {}};
  const LocalManifold &u = known.on.u.local, &s = known.on.s.local;
  const int images = images_to_the_middle(from);
  const std::size_t last = from.orbits.size() - 1;
  known.orbits.resize(last + 1);
  known.to_left.resize(last + 1);
  for (std::size_t k = last; k > 0; --k) {
    const ConnectingOrbit& orbit = from.orbits[k];
    try {
      known.orbits[k].residual = lost;
      if (from.is_lost(k)) continue;
      const OrbitTime time = expected(from, k, step, images);
      const DirectedOrbit found =
          directed_orbit(map, u, s, position_by(from.on.u.local.reach, u, time.u, orbit.u.parameter),
                         position_by(from.on.s.local.reach, s, time.s, orbit.s.parameter));
      known.orbits[k] = found.orbit;
      known.to_left[k] = found.to_left ? 1 : 0;
    } catch (const DataError&) {
      if (k == last) return std::nullopt;
    }
  }
  known.orbits.front() = preimage(map, known.on, known.orbits.back());
  known.past = past_of(from, step, images);
  return are_the_same(known, from, step, images) && order(known) ? std::optional(std::move(known)) : std::nullopt;
}

}  // namespace lober::detail
