#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/linear_algebra.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/periodic_orbit.hpp"

namespace lober {
using namespace detail;
namespace {

Matrix matrix_of(const FlowMatrix& matrix) {
  Matrix result(4, 4);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) result(i, j) = matrix[i][j];
  }
  return result;
}

double norm(const FlowState& state) {
  return std::hypot(std::hypot(state[0], state[1]), std::hypot(state[2], state[3]));
}

std::string format_state(const FlowState& state) {
  return "(" + std::to_string(state[0]) + ", " + std::to_string(state[1]) + ", " + std::to_string(state[2]) + ", " +
         std::to_string(state[3]) + ")";
}

FlowState equilibrium(const Flow& flow, const FlowState& guess) {
  FlowState x = guess, best = x;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 50; ++round) {
    const FlowState speed = flow.velocity(x, 0);
    const double size = norm(speed);
    if (!std::isfinite(size) || (round > 8 && size >= least)) break;
    if (size < least) {
      least = size;
      best = x;
    }
    const std::vector<double> step =
        least_squares(matrix_of(flow.jacobian(x, 0)), {speed[0], speed[1], speed[2], speed[3]});
    for (std::size_t k = 0; k < 4; ++k) x[k] -= step[k];
  }
  if (!(least <= 1e-10 * (1 + norm(best)))) {
    throw DataError("no equilibrium of the flow was found near " + format_state(guess));
  }
  return best;
}

void require_two_degrees_of_freedom(const Flow& flow) {
  if (flow.dimension() == 4 && flow.period() == 0 && flow.conjugate_pairs().size() == 2) return;
  throw UsageError("saddles with bottlenecks need an autonomous Hamiltonian flow of two degrees of freedom");
}

// One of the parts of a vector: std::real or std::imag.
template <typename Part>
FlowState part_of(const std::vector<std::complex<double>>& vector, const Part& part) {
  FlowState result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = part(vector[k]);
  return result;
}

}  // namespace

FlowState state_at_rest(const Flow& flow, Point position) {
  require_two_degrees_of_freedom(flow);
  std::array<std::size_t, 2> q{}, p{};
  for (std::size_t k = 0; k < 2; ++k) {
    q[k] = static_cast<std::size_t>(flow.conjugate_pairs()[k].q);
    p[k] = static_cast<std::size_t>(flow.conjugate_pairs()[k].p);
  }
  FlowState x{};
  x[q[0]] = position.x;
  x[q[1]] = position.y;
  for (int round = 0; round < 20; ++round) {
    const FlowState speed = flow.velocity(x, 0);
    const double size = std::hypot(speed[q[0]], speed[q[1]]);
    if (!std::isfinite(size)) break;
    if (size <= 1e-12 * (1 + norm(x))) return x;
    const FlowMatrix derivative = flow.jacobian(x, 0);
    Matrix by_momenta(2, 2);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) by_momenta(i, j) = derivative[q[i]][p[j]];
    }
    const std::vector<double> step = least_squares(by_momenta, {speed[q[0]], speed[q[1]]});
    for (std::size_t k = 0; k < 2; ++k) x[p[k]] -= step[k];
  }
  throw DataError("no momenta make the velocity zero at the position (" + format_number(position.x) + ", " +
                  format_number(position.y) + ")");
}

SaddlePoint saddle_point(const Flow& flow, const FlowState& guess) {
  require_two_degrees_of_freedom(flow);
  SaddlePoint saddle;
  saddle.at = equilibrium(flow, guess);
  saddle.energy = flow.hamiltonian(saddle.at, 0);
  const std::vector<EigenPair> pairs = eigen_pairs(matrix_of(flow.jacobian(saddle.at, 0)));
  double scale = 0;
  for (const EigenPair& pair : pairs) scale = std::max(scale, std::abs(pair.value));
  const EigenPair *real = nullptr, *imaginary = nullptr;
  int reals = 0, imaginaries = 0;
  for (const EigenPair& pair : pairs) {
    constexpr double small = 1e-7;
    const bool has_real = std::fabs(pair.value.real()) > small * scale;
    const bool has_imaginary = std::fabs(pair.value.imag()) > small * scale;
    if (has_real && !has_imaginary) {
      ++reals;
      if (pair.value.real() > 0) real = &pair;
    } else if (has_imaginary && !has_real) {
      ++imaginaries;
      if (pair.value.imag() > 0) imaginary = &pair;
    }
  }
  if (reals != 2 || imaginaries != 2 || real == nullptr || imaginary == nullptr) {
    throw DataError("the equilibrium " + format_state(saddle.at) + " is not a saddle of rank 1");
  }
  saddle.rate = real->value.real();
  saddle.frequency = imaginary->value.imag();
  const auto real_part = [](std::complex<double> value) { return value.real(); };
  const auto imaginary_part = [](std::complex<double> value) { return value.imag(); };
  saddle.unstable = part_of(real->vector, real_part);
  const double largest = *std::max_element(saddle.unstable.begin(), saddle.unstable.end(),
                                           [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  const double length = std::copysign(norm(saddle.unstable), largest);
  for (double& component : saddle.unstable) component /= length;
  saddle.centre_cos = part_of(imaginary->vector, real_part);
  saddle.centre_sin = part_of(imaginary->vector, imaginary_part);
  return saddle;
}

}  // namespace lober
