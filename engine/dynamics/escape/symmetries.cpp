#include "engine/dynamics/escape/symmetries.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace lober::detail {
namespace {

constexpr std::size_t dimension = 4;

struct Signs {
  std::array<double, dimension> sign;
  std::array<double, dimension> about;

  [[nodiscard]] FlowState operator()(const FlowState& state) const {
    FlowState result = state;
    for (std::size_t k = 0; k < dimension; ++k) result[k] = about[k] + sign[k] * (state[k] - about[k]);
    return result;
  }
};

// States in the box that the orbits span, enlarged by half.
std::vector<FlowState> states_about(std::span<const Bottleneck> bottlenecks) {
  FlowState low, high;
  low.fill(0);
  high.fill(0);
  for (std::size_t k = 0; k < dimension; ++k) {
    low[k] = high[k] = bottlenecks[0].orbit.state[k];
    for (const Bottleneck& bottleneck : bottlenecks) {
      for (const FlowState& state :
           {bottleneck.orbit.state, bottleneck.orbit.turning[0], bottleneck.orbit.turning[1]}) {
        low[k] = std::min(low[k], state[k]);
        high[k] = std::max(high[k], state[k]);
      }
    }
    const double margin = 0.25 * (high[k] - low[k]) + 1e-3 * (1 + std::fabs(high[k]));
    low[k] -= margin;
    high[k] += margin;
  }
  std::vector<FlowState> states(48);
  std::uint64_t bits = 1;
  for (FlowState& state : states) {
    state.fill(0);
    for (std::size_t k = 0; k < dimension; ++k) {
      bits = bits * 6364136223846793005U + 1442695040888963407U;  // Knuth's generator: any spread will do
      state[k] = low[k] + (high[k] - low[k]) * static_cast<double>(bits >> 11) * 0x1p-53;
    }
  }
  return states;
}

bool keeps_hamiltonian(const Flow& flow, const Signs& signs, std::span<const FlowState> states) {
  for (const FlowState& state : states) {
    const double here = flow.hamiltonian(state, 0), there = flow.hamiltonian(signs(state), 0);
    if (!(std::fabs(here - there) <= 1e-12 * (1 + std::fabs(here)))) return false;
  }
  return true;
}

// Empty when some bottleneck becomes none.
std::vector<std::size_t> permutation(const Signs& signs, std::span<const Bottleneck> bottlenecks) {
  std::vector<std::size_t> becomes;
  for (const Bottleneck& bottleneck : bottlenecks) {
    const FlowState image = signs(bottleneck.orbit.saddle.at);
    for (std::size_t j = 0; j < bottlenecks.size(); ++j) {
      double distance = 0;
      for (std::size_t k = 0; k < dimension; ++k) distance += std::fabs(image[k] - bottlenecks[j].orbit.saddle.at[k]);
      if (distance < 1e-6) {
        becomes.push_back(j);
        break;
      }
    }
  }
  return becomes.size() == bottlenecks.size() ? becomes : std::vector<std::size_t>();
}

}  // namespace

std::vector<EscapeSymmetry> symmetries(const Flow& flow, const Section& section,
                                       std::span<const Bottleneck> bottlenecks) {
  const std::vector<FlowState> states = states_about(bottlenecks);
  const auto pairs = flow.conjugate_pairs();
  std::vector<EscapeSymmetry> found;
  for (unsigned pattern = 1; pattern < 1U << dimension; ++pattern) {
    Signs signs{};
    for (std::size_t k = 0; k < dimension; ++k) signs.sign[k] = (pattern >> k & 1U) != 0 ? -1 : 1;
    signs.about[static_cast<std::size_t>(section.coordinate)] = section.value;
    const auto of_pair = [&](const ConjugatePair& pair) {
      return signs.sign[static_cast<std::size_t>(pair.q)] * signs.sign[static_cast<std::size_t>(pair.p)];
    };
    if (of_pair(pairs[0]) != of_pair(pairs[1]) || !keeps_hamiltonian(flow, signs, states)) continue;
    std::vector<std::size_t> becomes = permutation(signs, bottlenecks);
    if (!becomes.empty()) found.push_back({of_pair(pairs[0]) < 0, std::move(becomes)});
  }
  return found;
}

}  // namespace lober::detail
