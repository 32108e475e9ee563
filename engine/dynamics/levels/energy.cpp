#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "engine/dynamics/maps/linear_algebra.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/levels.hpp"

namespace lober {
using namespace detail;
namespace {

void require_energy(const Flow& flow) {
  const std::size_t pairs = flow.conjugate_pairs().size();
  if (pairs == 0) throw UsageError("the flow has no Hamiltonian, and so no level curves of energy");
  if (static_cast<std::size_t>(flow.dimension()) != 2 * pairs || pairs > 2) {
    throw UsageError("level curves of energy need a flow of two or four dimensions, not of " +
                     std::to_string(flow.dimension()));
  }
}

// The least value of a quadratic function of two numbers, from six of its values; NaN where it has none.
template <typename Function>
double least_of_quadratic(const Function& value) {
  const double h = value(0, 0), right = value(1, 0), left = value(-1, 0), up = value(0, 1), down = value(0, -1);
  const double gx = 0.5 * (right - left), gy = 0.5 * (up - down);
  const double xx = right + left - 2 * h, yy = up + down - 2 * h, xy = value(1, 1) - right - up + h;
  const double determinant = xx * yy - xy * xy;
  if (!(xx > 0 && determinant > 0)) return std::numeric_limits<double>::quiet_NaN();
  return h - 0.5 * (yy * gx * gx - 2 * xy * gx * gy + xx * gy * gy) / determinant;
}

}  // namespace

PlaneFunction energy_of(const Flow& flow, double time) {
  require_energy(flow);
  const auto pairs = flow.conjugate_pairs();
  if (pairs.size() == 1) {
    return [&flow, time](Point at) { return flow.hamiltonian(FlowState{at.x, at.y}, time); };
  }
  const std::array<std::size_t, 4> index{static_cast<std::size_t>(pairs[0].q), static_cast<std::size_t>(pairs[1].q),
                                         static_cast<std::size_t>(pairs[0].p), static_cast<std::size_t>(pairs[1].p)};
  return [&flow, time, index](Point at) {
    return least_of_quadratic([&](double first, double second) {
      FlowState state{};
      state[index[0]] = at.x;
      state[index[1]] = at.y;
      state[index[2]] = first;
      state[index[3]] = second;
      return flow.hamiltonian(state, time);
    });
  };
}

Equilibrium equilibrium_near(const Flow& flow, const FlowState& guess, double time) {
  require_energy(flow);
  const auto n = static_cast<std::size_t>(flow.dimension());
  const auto size_of = [&](const FlowState& state) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += state[k] * state[k];
    return std::sqrt(sum);
  };
  const auto matrix_at = [&](const FlowState& state) {
    const FlowMatrix jacobian = flow.jacobian(state, time);
    Matrix matrix(n, n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) matrix(i, j) = jacobian[i][j];
    }
    return matrix;
  };
  FlowState x = guess, best = guess;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 50; ++round) {
    const FlowState speed = flow.velocity(x, time);
    const double size = size_of(speed);
    if (!std::isfinite(size) || (round > 8 && size >= least)) break;
    if (size < least) {
      least = size;
      best = x;
    }
    const std::vector<double> step = least_squares(matrix_at(x), {speed.begin(), speed.begin() + flow.dimension()});
    for (std::size_t k = 0; k < n; ++k) x[k] -= step[k];
  }
  if (!(least <= 1e-10 * (1 + size_of(best)))) {
    throw DataError("no equilibrium of the flow was found near (" + std::to_string(guess[0]) + ", " +
                    std::to_string(guess[1]) + ")");
  }
  const auto pairs = flow.conjugate_pairs();
  Equilibrium result;
  result.at = pairs.size() == 1
                  ? Point{best[0], best[1]}
                  : Point{best[static_cast<std::size_t>(pairs[0].q)], best[static_cast<std::size_t>(pairs[1].q)]};
  result.energy = flow.hamiltonian(best, time);
  for (const EigenPair& pair : eigen_pairs(matrix_at(best))) {
    result.saddle = result.saddle || pair.value.real() > 1e-8 * std::abs(pair.value);
  }
  return result;
}

}  // namespace lober
