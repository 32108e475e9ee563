// Whether the pips of polygons are those of the manifolds: by their splitting, by orbits, and by action.
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/tangles/tangle_box.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Polygons are finer than lobes are wide on average by this factor.
constexpr double tolerances_wide = 10;

}  // namespace

// The tolerance that polygons need for their crossings to be those of the manifolds; nothing where it is not known.
// Throws DataError where the manifolds coincide.
std::optional<double> TangleGrowth::tolerance_for_splitting() {
  if (!splitting_) {
    const auto [u, s] = positions_of(bip_);
    splitting_ = splitting(map_, u_.local, s_.local, u, s);
  }
  if (!splitting_) return std::nullopt;
  if (splitting_->coincide()) {
    throw DataError("the manifolds coincide as far as can be seen: along one iterate they lie no farther apart than " +
                    format_rounded(splitting_->largest) +
                    ", which rounding and integration explain; there are no lobes");
  }
  // Near a pip of that amplitude A polygons are refined until their segments turn by less than the angle at which the
  // manifolds cross, A / L: over a length tolerance / (A / L), with segments of A / L. Together with sqrt(1 /
  // tolerance) elsewhere that makes the fewest points for A^(4/3).
  const double amplitude = splitting_->amplitude, size = box_.extent() / times_scene;
  const double wanted = std::min(amplitude / finer_than_splitting, size * elementary::power(amplitude / size, 4.0 / 3));
  // Points are off by some roundings, and polygons whose segments are so short that they turn by less than the
  // manifolds cross at then cross at random: measured on the standard map for K = 0.11 to 0.14.
  constexpr double finest_that_cross = 40;
  if (wanted < finest_that_cross * finest_) {
    throw DataError("the manifolds lie only " + format_rounded(splitting_->largest) +
                    " apart: no polygons in double precision show how they cross" + by_action());
  }
  return wanted;
}

// Whether a lobe of the turnstile is thin.
bool TangleGrowth::lobes_are_thin() const {
  const Buffer<Point>& points = u_.growth->grown().points;
  for (std::size_t k = bip_ - std::min<std::size_t>(period_, bip_); k < bip_; ++k) {
    double length = 0;
    for (std::size_t i = found_.pips[k].u.segment; i <= found_.pips[k + 1].u.segment; ++i)
      length += distance(points[i], points[i + 1]);
    if (std::fabs(found_.lobes[k].area) < tolerances_wide * tolerance_ * length) return true;
  }
  return false;
}

// The orbit through a pip: an image of one that is known, if the polygons show it there, or else by Newton's method.
ConnectingOrbit TangleGrowth::orbit_through(std::size_t pip) const {
  constexpr double close = 1e-3;  // in images
  const auto [u, s] = positions_of(pip);
  const Time time = {time_of(u_.local, u), time_of(s_.local, s)};
  for (const ConnectingOrbit& known : known_orbits_) {
    const Time there = {time_of(u_.local, known.u), time_of(s_.local, known.s)};
    const double images = std::round(time.u - there.u);
    if (!(std::fabs(time.u - there.u - images) <= close && std::fabs(time.s - there.s + images) <= close)) continue;
    if (images == 0) return known;
    ConnectingOrbit orbit = known;
    orbit.u = position_at(u_.local, there.u + images, known.u.parameter);
    orbit.s = position_at(s_.local, there.s - images, known.s.parameter);
    orbit.at = u_.local.at(orbit.u.parameter);
    map_.iterate({&orbit.at, 1}, orbit.u.images * u_.local.image().steps);
    return orbit;
  }
  return connecting_orbit(map_, u_.local, s_.local, u, s);
}

// Why the pips of the turnstile are not those of the manifolds; empty if they are. Leaves their orbits.
std::string TangleGrowth::trouble_with_pips() {
  const std::string polygons = " (polygons to the tolerance " + tolerance_text() + ")";
  if (period_ % 2 == 1)
    return std::to_string(period_) +
           " pips a period, an odd number: a map takes pips to pips of the same direction, and those alternate" +
           polygons;
  if (splitting_ && splitting_->zeros != period_) {
    return std::to_string(period_) + " pips a period, but the distance of the manifolds changes sign " +
           std::to_string(splitting_->zeros) + " times" + polygons;
  }
  orbits_.clear();
  try {
    for (std::size_t k = bip_ - period_; k <= bip_; ++k) orbits_.push_back(orbit_through(k));
  } catch (const DataError& error) {
    return error.what() + polygons;
  }
  constexpr double apart = 1e-9;  // in images
  for (std::size_t k = 0; k + 1 < orbits_.size(); ++k) {
    const ConnectingOrbit &first = orbits_[k], &last = orbits_[k + 1];
    if (!(time_of(u_.local, last.u) > time_of(u_.local, first.u) + apart) ||
        !(time_of(s_.local, last.s) < time_of(s_.local, first.s) - apart)) {
      return "two pips near " + format_point(first.at) + " lead to one orbit" + polygons;
    }
    const auto area = lobe_area_by_action(first, last);
    if (area && !(std::fabs(*area) > first.action_error + last.action_error))
      return "a lobe near " + format_point(first.at) + " has no area by action that exceeds its error, " +
             format_rounded(first.action_error + last.action_error) + polygons;
    if (area && std::signbit(*area) != std::signbit(found_.lobes[bip_ - period_ + k].area))
      return "the lobe behind " + format_point(first.at) +
             " lies on one side by its polygon and on the other one by action" + polygons;
  }
  const double turn = time_of(u_.local, orbits_.back().u) - time_of(u_.local, orbits_.front().u);
  if (std::fabs(turn - 1) > 1e-6)
    return "the pip " + format_point(orbits_.back().at) + " is not the image of the pip a period before" + polygons;
  return {};
}

// "; by action ..." where the orbits through the zeros of the splitting are found.
std::string TangleGrowth::by_action() const {
  if (!splitting_ || splitting_->coincide() || splitting_->near_zeros.size() < 2) return {};
  std::string text;
  try {
    std::vector<ConnectingOrbit> orbits;
    for (const auto& [u, s] : splitting_->near_zeros)
      orbits.push_back(connecting_orbit(map_, u_.local, s_.local, u, s));
    for (std::size_t k = 0; k + 1 < orbits.size(); ++k) {
      const auto area = lobe_area_by_action(orbits[k], orbits[k + 1]);
      if (!area) return {};
      text += (k == 0 ? "; by action the areas of the lobes are " : ", ") + format_number(*area) + " +- " +
              format_rounded(orbits[k].action_error + orbits[k + 1].action_error);
    }
  } catch (const DataError&) {
    return {};
  }
  return text;
}

}  // namespace lober::detail
