// The saddles of a well, their periodic orbits and tubes, and the messages where these do not serve.
#include "engine/dynamics/escape/bottlenecks.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "engine/base/quantities.hpp"
#include "engine/dynamics/escape/least_excess.hpp"

namespace lober::detail {

std::vector<SaddlePoint> Bottlenecks::also_open() const {
  std::vector<SaddlePoint> others = open_saddles();
  others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(list.size()));
  const auto axis = static_cast<std::size_t>(section_.coordinate);
  std::stable_sort(others.begin(), others.end(), [&](const auto& x, const auto& y) { return x.at[axis] < y.at[axis]; });
  return others;
}

void Bottlenecks::throw_outside() const {
  throw DataError("no trajectory comes back to the section, which lies outside of the well. " + way_on());
}

std::string Bottlenecks::name_of_tube(std::size_t k) const {
  return std::string(k % 2 == 0 ? "the unstable" : "the stable") + " tube of the bottleneck " +
         name_of_saddle(list[k / 2].orbit.saddle);
}

std::string Bottlenecks::way_on() const {
  const std::vector<SaddlePoint> open = open_saddles();
  std::string names;
  for (const SaddlePoint& saddle : open) names += (names.empty() ? "" : ", ") + name_of_saddle(saddle);
  return "The energy " + format_number(list[0].orbit.energy) + " is above that of " + std::to_string(open.size()) +
         (open.size() == 1 ? " saddle, " : " saddles, ") + names + "; give " + std::string(quantity::saddles) +
         ", and " + std::string(quantity::section) + " that none of their orbits meets";
}

std::vector<SaddlePoint> Bottlenecks::open_saddles() const {
  constexpr int cells = 8;
  double reach = 0;
  const auto q = [&](const SaddlePoint& saddle, std::size_t k) {
    return saddle.at[static_cast<std::size_t>(flow_.conjugate_pairs()[k].q)];
  };
  std::vector<SaddlePoint> found;
  const auto add = [&](const SaddlePoint& saddle) {
    const bool known = std::any_of(found.begin(), found.end(), [&](const SaddlePoint& other) {
      return std::hypot(q(other, 0) - q(saddle, 0), q(other, 1) - q(saddle, 1)) < 1e-6 * (1 + reach);
    });
    if (!known && saddle.energy < list[0].orbit.energy) found.push_back(saddle);
  };
  for (const Bottleneck& bottleneck : list) {
    add(bottleneck.orbit.saddle);
    for (const std::size_t k : {0U, 1U}) reach = std::max(reach, 1.5 * std::fabs(q(bottleneck.orbit.saddle, k)));
  }
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      FlowState guess{};
      guess[static_cast<std::size_t>(flow_.conjugate_pairs()[0].q)] = reach * (2.0 * i / cells - 1);
      guess[static_cast<std::size_t>(flow_.conjugate_pairs()[1].q)] = reach * (2.0 * j / cells - 1);
      try {
        add(saddle_point(flow_, guess));
      } catch (const Error&) {  // no saddle of rank 1 is near
      }
    }
  }
  return found;
}

std::string Bottlenecks::name_of_saddle(const SaddlePoint& saddle) {
  const double scale = std::hypot(saddle.at[0], saddle.at[1]);
  const auto text = [&](double x) { return format_rounded(std::fabs(x) < 1e-12 * scale ? 0 : x, 6); };
  return "(" + text(saddle.at[0]) + ", " + text(saddle.at[1]) + ")";
}

void Bottlenecks::require_energy_above(std::span<const SaddlePoint> saddles, double energy) {
  const auto highest = std::max_element(saddles.begin(), saddles.end(),
                                        [](const auto& x, const auto& y) { return x.energy < y.energy; });
  if (energy > highest->energy && std::isfinite(energy)) return;
  std::string below;
  for (const SaddlePoint& saddle : saddles) {
    if (energy > saddle.energy) below += (below.empty() ? "" : ", ") + name_of_saddle(saddle);
  }
  throw UsageError("the energy " + format_number(energy) + " is not above that of the saddle " +
                   name_of_saddle(*highest) + ", " + format_number(highest->energy) +
                   ", so that the bottleneck there is closed; energies from about " + text_of_least(*highest) +
                   " on can be used" +
                   (below.empty() ? "" : "; open are " + below + ": give " + std::string(quantity::saddles)));
}

double Bottlenecks::least_energy(const SaddlePoint& saddle) {
  return saddle.energy + least_excess(saddle);
}

void Bottlenecks::find_orbits(std::span<const FlowState> guesses, double energy) {
  if (guesses.empty()) throw UsageError("escape needs at least one saddle");
  report_("periodic orbits");
  const auto axis = static_cast<std::size_t>(section_.coordinate);
  IntegrationOptions exact = options_.integration;
  exact.tolerance = std::min(exact.tolerance, 3e-15);
  std::vector<SaddlePoint> saddles;
  for (const FlowState& guess : guesses) saddles.push_back(saddle_point(flow_, guess));
  require_energy_above(saddles, energy);
  for (const SaddlePoint& saddle : saddles) {
    Bottleneck bottleneck;
    near_saddle(saddle, energy, [&] { bottleneck.orbit = periodic_orbit(flow_, saddle, energy, exact); });
    for (const Bottleneck& other : list) {
      double distance = 0;
      for (std::size_t k = 0; k < 4; ++k) distance += std::fabs(other.orbit.state[k] - bottleneck.orbit.state[k]);
      if (distance < 1e-9) throw UsageError("two of the saddles are the same point; give each saddle once");
    }
    list.push_back(std::move(bottleneck));
  }
  std::stable_sort(list.begin(), list.end(), [&](const Bottleneck& x, const Bottleneck& y) {
    return x.orbit.saddle.at[axis] < y.orbit.saddle.at[axis];
  });
}

void Bottlenecks::require_off_section() const {
  constexpr std::size_t samples = 128;
  const auto across = static_cast<std::size_t>(section_.coordinate);
  const auto counts = [&](const FlowState& state) {
    return section_.bound_side == 0 ||
           section_.bound_side * (state[static_cast<std::size_t>(section_.bound_coordinate)] - section_.bound) > 0;
  };
  for (const Bottleneck& bottleneck : list) {
    const std::vector<FlowState> states = states_along(flow_, bottleneck.orbit, samples, options_.integration);
    for (std::size_t k = 0; k < states.size(); ++k) {
      const FlowState &here = states[k], &next = states[(k + 1) % states.size()];
      if ((here[across] < section_.value) == (next[across] < section_.value) || !counts(here)) continue;
      throw DataError("the section cuts the periodic orbit of the bottleneck " +
                      name_of_saddle(bottleneck.orbit.saddle) +
                      ", and trajectories beside that orbit cross it turn after turn. " + way_on());
    }
  }
}

void Bottlenecks::find_tubes() {
  report_("local manifolds");
  tubes_.resize(2 * list.size());
  std::vector<std::exception_ptr> failures(tubes_.size());  // the first one counts, whatever failed earlier
  for_each_block(tubes_.size(), 1, [&](std::size_t k, std::size_t) {
    Bottleneck& bottleneck = list[k / 2];
    try {
      near_saddle(bottleneck.orbit.saddle, bottleneck.orbit.energy, [&] {
        tubes_[k].emplace(flow_, bottleneck.orbit, k % 2 == 0 ? ManifoldSide::unstable : ManifoldSide::stable,
                          options_.integration);
      });
      const std::optional<Branch> towards = tubes_[k]->branch_towards(section_);
      if (!towards) {
        throw DataError("neither branch of " + name_of_tube(k) + " reaches the section as a closed curve. " + way_on());
      }
      (k % 2 == 0 ? bottleneck.entry_branch : bottleneck.exit_branch) = *towards;
    } catch (const DataError&) {
      failures[k] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Tube &entry = *tubes_[2 * k], &exit = *tubes_[2 * k + 1];
    list[k].area = entry.area_by_action(section_);
    list[k].area_error = list[k].area * list[k].orbit.action_error / std::fabs(list[k].orbit.action);
    list[k].multiplier = entry.local().multiplier;
    list[k].defect_across = std::max(entry.local().defect_across, exit.local().defect_across);
    least_area_ = std::min(least_area_, list[k].area);
  }
  for (std::size_t k = 0; k < tubes_.size(); ++k) {
    Bottleneck& bottleneck = list[k / 2];
    carried_.push_back({k % 2 == 0 ? &bottleneck.entry : &bottleneck.exit,
                        k % 2 == 0 ? bottleneck.entry_branch : bottleneck.exit_branch, nullptr, false});
  }
  tracing_.tolerance = options_.tolerance * std::sqrt(least_area_);
  tracing_.max_points = options_.max_points;
  tracing_.progress = [this](const std::string&) { return report_("tubes"), true; };
}

}  // namespace lober::detail
