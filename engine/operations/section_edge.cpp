#include "engine/operations/section_edge.hpp"

#include <cmath>
#include <limits>

namespace lober::detail {
namespace {

constexpr std::size_t edge_cells = 240;

// From three values of the Hamiltonian, a v^2 + b v + c in the solved coordinate v.
double least_energy(const Flow& flow, const Section& section, Point at) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto index = [](int coordinate) { return static_cast<std::size_t>(coordinate); };
  FlowState state{};
  state[index(section.coordinate)] = section.value;
  state[index(section.chart_x)] = at.x;
  state[index(section.chart_y)] = at.y;
  if (section.bound_side * (state[index(section.bound_coordinate)] - section.bound) < 0) return none;
  const auto value = [&](double v) {
    state[index(section.solved)] = v;
    return flow.hamiltonian(state, 0);
  };
  const double below = value(-1), c = value(0), above = value(1);
  const double a = 0.5 * (above + below) - c, b = 0.5 * (above - below);
  return a > 0 ? c - 0.25 * b * b / a : none;
}

}  // namespace

std::vector<LevelCurve> section_edge(const Flow& flow, const Section& section, double energy, const Rectangle& window) {
  if (section.solved < 0) return {};
  const LevelGrid grid([&](Point at) { return least_energy(flow, section, at); }, window, edge_cells, edge_cells);
  return grid.curves(energy);
}

}  // namespace lober::detail
