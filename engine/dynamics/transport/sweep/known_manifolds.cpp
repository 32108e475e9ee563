#include "engine/dynamics/transport/sweep/known_manifolds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/dynamics/transport/tangles/tangle_growth.hpp"
#include "kernels/chebyshev.hpp"

namespace lober::detail {
namespace {

// The part of a manifold up to a smaller reach.
LocalManifold with_reach(LocalManifold local, double reach) {
  const std::size_t size = local.coefficients.size();
  std::vector<double> parameters(size);
  for (std::size_t k = 0; k < size; ++k) parameters[k] = reach * chebyshev_node(k, size);
  std::vector<Point> points(size);
  local.points_at(parameters, points);
  chebyshev_coefficients(points, local.coefficients);
  local.reach = reach;
  return local;
}

// `local`, `step` on from one that is known, with what it has in common with that one's past. Manifolds of different
// reach have no coefficients to compare: one that is much longer begins a past of its own, and one that is a little
// longer is cut.
KnownManifold after(const KnownManifold& from, LocalManifold local, double step) {
  constexpr double much_longer = 1.4;
  const double reach = from.local.reach;
  if (step == 0 || local.coefficients.size() != from.local.coefficients.size()) return {std::move(local), {}, {}, 0, 0};
  if (local.reach > much_longer * reach) {
    KnownManifold part = after(from, with_reach(local, reach), step);
    return {std::move(local), {}, std::make_shared<const KnownManifold>(std::move(part)), 0, 0};
  }
  KnownManifold result{local.reach > reach ? with_reach(std::move(local), reach) : std::move(local), {}, {}, 0, 0};
  const bool shorter = result.local.reach < reach;
  const LocalManifold before = shorter ? with_reach(from.local, result.local.reach) : from.local;
  result.past.push_back({-step, before.saddle, before.multiplier, before.coefficients});
  for (const KnownManifold::Past& past : from.past) {
    if (shorter || result.past.size() + 1 == values_to_extrapolate) break;
    if (!lies_apart(past.offset, step)) continue;
    result.past.push_back(past);
    result.past.back().offset -= step;
  }
  return result;
}

// The same, and whether to make the next one longer: after each failure not for twice as many steps as before.
KnownManifold continued(const KnownManifold& from, LocalManifold local, double step) {
  KnownManifold result = after(from, std::move(local), step);
  if (result.part) return result;
  const bool tried = from.waited >= from.wait;
  result.waited = tried ? 1 : from.waited + 1;
  result.wait = tried ? std::max(2 * from.wait, 2) : from.wait;
  return result;
}

const KnownManifold& with_past(const KnownManifold& known) {
  return known.past.empty() && known.part ? *known.part : known;
}

}  // namespace

bool lies_apart(double offset, double step) {
  const double shortest = shortest_past * std::fabs(step);
  return std::fabs(offset) >= shortest && std::fabs(offset - step) >= shortest;
}

std::vector<double> interpolation_weights(std::span<const double> offsets, double at) {
  std::vector<double> weights(offsets.size(), 1);
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    for (std::size_t j = 0; j < offsets.size(); ++j) {
      if (j != k) weights[k] *= (at - offsets[j]) / (offsets[k] - offsets[j]);
    }
  }
  return weights;
}

LocalManifold KnownManifold::at(double offset) const {
  std::vector<double> offsets{0};
  for (const Past& there : past) {
    if (std::fabs(there.offset) < shortest_past * std::fabs(offset)) break;
    offsets.push_back(there.offset);
  }
  const std::vector<double> weights = interpolation_weights(offsets, offset);
  LocalManifold result = local;
  // As sums of differences, which are small.
  const auto add = [](Point& to, double weight, Point there, Point here) {
    to = {to.x + weight * (there.x - here.x), to.y + weight * (there.y - here.y)};
  };
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    add(result.saddle, weights[k + 1], past[k].saddle, local.saddle);
    result.multiplier += weights[k + 1] * (past[k].multiplier - local.multiplier);
    for (std::size_t j = 0; j < local.coefficients.size(); ++j)
      add(result.coefficients[j], weights[k + 1], past[k].coefficients[j], local.coefficients[j]);
  }
  return result;
}

KnownManifolds continued_manifolds(const PlanarMap& map, const Connection& connection, const KnownManifolds& from,
                                   double step) {
  const LocalManifold near_u = with_past(from.u).at(step), near_s = with_past(from.s).at(step);
  // No farther than before where it has to be grown again from a part, so that it fits what is known, or where that has
  // failed of late.
  const auto options_of = [&](const LocalManifold& near, const KnownManifold& before) {
    LocalManifoldOptions options{.neighbour = &near};
    options.outgrow_neighbour = near.reach < before.local.reach || before.waited >= before.wait;
    if (near.reach < before.local.reach) options.max_length = before.local.reach / map.unit();
    return options;
  };
  Connection between = connection;
  between.from = near_u.saddle;
  between.to = near_s.saddle;
  auto [u, s] = local_manifolds(map, between, options_of(near_u, from.u), options_of(near_s, from.s));
  return {continued(from.u, std::move(u), step), continued(from.s, std::move(s), step)};
}

bool are_known_between(const KnownManifolds& to) {
  const auto with_two = [](const KnownManifold& known) { return with_past(known).past.size() >= 2; };
  return with_two(to.u) && with_two(to.s);
}

KnownManifolds manifolds_between(const KnownManifolds& to, double step) {
  return {{with_past(to.u).at(step), {}, {}, 0, 0}, {with_past(to.s).at(step), {}, {}, 0, 0}};
}

}  // namespace lober::detail
