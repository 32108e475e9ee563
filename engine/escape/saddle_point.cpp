#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "engine/error.hpp"
#include "engine/escape/periodic_orbit.hpp"

namespace lober {
namespace {

Eigen::Vector4d vector_of(const FlowState& state) {
  return {state[0], state[1], state[2], state[3]};
}

FlowState state_of(const Eigen::Vector4d& vector) {
  FlowState state{};
  for (std::size_t k = 0; k < 4; ++k) state[k] = vector(static_cast<Eigen::Index>(k));
  return state;
}

Eigen::Matrix4d matrix_of(const FlowMatrix& matrix) {
  Eigen::Matrix4d result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix[i][j];
    }
  }
  return result;
}

std::string place(const FlowState& state) {
  return "(" + std::to_string(state[0]) + ", " + std::to_string(state[1]) + ", " + std::to_string(state[2]) + ", " +
         std::to_string(state[3]) + ")";
}

FlowState equilibrium(const Flow& flow, const FlowState& guess) {
  Eigen::Vector4d x = vector_of(guess), best = x;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 50; ++round) {
    const Eigen::Vector4d speed = vector_of(flow.velocity(state_of(x), 0));
    const double size = speed.norm();
    if (!std::isfinite(size) || (round > 8 && size >= least)) break;
    if (size < least) {
      least = size;
      best = x;
    }
    x -= matrix_of(flow.jacobian(state_of(x), 0)).fullPivLu().solve(speed);
  }
  if (!(least <= 1e-10 * (1 + best.norm()))) {
    throw DataError("no equilibrium of the flow was found near " + place(guess));
  }
  return state_of(best);
}

}  // namespace

SaddlePoint saddle_point(const Flow& flow, const FlowState& guess) {
  if (flow.dimension() != 4 || flow.period() != 0 || flow.conjugate_pairs().size() != 2) {
    throw UsageError("saddles with bottlenecks need an autonomous Hamiltonian flow of two degrees of freedom");
  }
  SaddlePoint saddle;
  saddle.at = equilibrium(flow, guess);
  saddle.energy = flow.hamiltonian(saddle.at, 0);
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(matrix_of(flow.jacobian(saddle.at, 0)));
  const auto& values = solver.eigenvalues();
  const double scale = values.cwiseAbs().maxCoeff();
  Eigen::Index real = -1, imaginary = -1;
  int reals = 0, imaginaries = 0;
  for (Eigen::Index k = 0; k < 4; ++k) {
    constexpr double small = 1e-7;
    const std::complex<double> value = values(k);
    if (std::fabs(value.imag()) <= small * scale && std::fabs(value.real()) > small * scale) {
      ++reals;
      if (value.real() > 0) real = k;
    } else if (std::fabs(value.real()) <= small * scale && std::fabs(value.imag()) > small * scale) {
      ++imaginaries;
      if (value.imag() > 0) imaginary = k;
    }
  }
  if (reals != 2 || imaginaries != 2 || real < 0 || imaginary < 0) {
    throw DataError("the equilibrium " + place(saddle.at) + " is no saddle of rank 1");
  }
  saddle.rate = values(real).real();
  saddle.frequency = values(imaginary).imag();
  Eigen::Vector4d unstable = solver.eigenvectors().col(real).real();
  Eigen::Index largest = 0;
  unstable.cwiseAbs().maxCoeff(&largest);
  unstable /= std::copysign(unstable.norm(), unstable(largest));
  saddle.unstable = state_of(unstable);
  const Eigen::Vector4cd centre = solver.eigenvectors().col(imaginary);
  saddle.centre_cos = state_of(centre.real());
  saddle.centre_sin = state_of(centre.imag());
  return saddle;
}

}  // namespace lober
