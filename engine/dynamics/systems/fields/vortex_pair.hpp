// The velocity fields of the oscillating vortex pair.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "kernels/elementary.hpp"
#include "kernels/inline.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

inline constexpr std::array<ConjugatePair, 1> stream_function_pair{{{0, 1, 1}}};

/// The vortices are at (xv, +-yv):
///   yv = exp(eps (cos(t/gamma) - 1)),   vv = e^eps / (2 I0(eps)),
///   xv = -gamma e^{eps (1 - cos(t/gamma))} / I0(eps) * sum_{k >= 1} I_k(eps) sin(k t/gamma) / k,
/// and the stream function is -1/2 log(R-/R+) - vv y + (eps/gamma) x y sin(t/gamma), R-+ = (x - xv)^2 + (y -+ yv)^2.
class VortexPair {
 public:
  static constexpr int dimension = 2;
  static constexpr std::size_t forcings = 3;  // the upper vortex, and the rate of strain
  static constexpr bool in_lanes = true;

  VortexPair(double gamma, double eps)
      : gamma_(gamma), eps_(eps), vv_(0.5 * elementary::exp(eps) / elementary::bessel_i(0, eps)) {
    // I_k(-e) = (-1)^k I_k(e). The terms fall off faster than (e/2)^k / k!.
    const double size = std::abs(eps);
    for (std::size_t k = 1; k <= max_terms; ++k) {
      const double sign = eps < 0 && k % 2 == 1 ? -1 : 1;
      coefficient_[k] = sign * elementary::bessel_i(static_cast<int>(k), size) /
                        (static_cast<double>(k) * elementary::bessel_i(0, size));
      if (std::abs(coefficient_[k]) > 1e-19) terms_ = k;
    }
  }

  [[nodiscard]] double period() const { return 2 * std::numbers::pi * gamma_; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return stream_function_pair; }

  void forcing(double t, double* force) const {
    const double sine = elementary::sin(t / gamma_);
    const double cosine = elementary::cos(t / gamma_);
    // Clenshaw's recurrence for sum c_k sin(k theta).
    double next = 0, after = 0;
    for (std::size_t k = terms_; k >= 1; --k) {
      const double here = coefficient_[k] + 2 * cosine * next - after;
      after = next;
      next = here;
    }
    const double y = elementary::exp(eps_ * (cosine - 1));
    force[0] = -gamma_ / y * next * sine;
    force[1] = y;
    force[2] = eps_ / gamma_ * sine;
  }

  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* force) const {
    const T across = x[0] - force[0];
    const T up = x[1] - force[1];
    const T down = x[1] + force[1];
    const T square = across * across;
    const T near = 1.0 / (square + up * up);
    const T far = 1.0 / (square + down * down);
    dxdt[0] = down * far - up * near - vv_ + x[0] * force[2];
    dxdt[1] = across * (near - far) - x[1] * force[2];
  }

  double hamiltonian(const double* x, const double* force) const {
    const double square = (x[0] - force[0]) * (x[0] - force[0]);
    // R- / R+ = 1 - 4 y yv / R+
    const double far = square + (x[1] + force[1]) * (x[1] + force[1]);
    return -0.5 * elementary::log1p(-4 * x[1] * force[1] / far) - vv_ * x[1] + x[0] * x[1] * force[2];
  }

 private:
  static constexpr std::size_t max_terms = 40;
  double gamma_;
  double eps_;
  double vv_;
  std::array<double, max_terms + 1> coefficient_{};
  std::size_t terms_ = 0;
};

/// The same to first order in eps. dy/dt = f2 + eps g2: the minus in Eq. (ovp_expansion_eps) of Naik, Lekien & Ross
/// (2017) would not preserve area.
class FirstOrderVortexPair {
 public:
  static constexpr int dimension = 2;
  static constexpr std::size_t forcings = 2;  // sin(t / gamma) and cos(t / gamma) - 1
  static constexpr bool in_lanes = true;

  FirstOrderVortexPair(double gamma, double eps) : gamma_(gamma), eps_(eps) {}

  [[nodiscard]] double period() const { return 2 * std::numbers::pi * gamma_; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return stream_function_pair; }

  void forcing(double t, double* force) const {
    force[0] = elementary::sin(t / gamma_);
    force[1] = elementary::cos(t / gamma_) - 1;
  }

  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* force) const {
    const V s = force[0] * gamma_, strain = force[0] * (1 / gamma_);
    const V c1 = force[1];
    const T up = x[1] - 1.0;
    const T down = x[1] + 1.0;
    const T square = x[0] * x[0];
    const T near = 1.0 / (square + up * up);     // 1 / I-
    const T far = 1.0 / (square + down * down);  // 1 / I+
    const T up2 = up * near * near;              // (y - 1) / I-^2
    const T down2 = down * far * far;
    const T g1 = (near + far - 2.0 * (up * up2 + down * down2)) * c1 + x[0] * ((up2 - down2) * s + strain) - 0.5;
    const T g2 = x[0] * ((up2 + down2) * (2.0 * c1)) + (0.5 * (near - far) - square * (near * near - far * far)) * s -
                 x[1] * strain;
    dxdt[0] = down * far - up * near - 0.5 + eps_ * g1;
    dxdt[1] = x[0] * (near - far) + eps_ * g2;
  }

  double hamiltonian(const double* x, const double* force) const {
    const double s = force[0];
    const double c1 = force[1];
    const double square = x[0] * x[0];
    const double near = square + (x[1] - 1) * (x[1] - 1);
    const double far = square + (x[1] + 1) * (x[1] + 1);
    const double psi0 = -0.5 * elementary::log1p(-4 * x[1] / far) - 0.5 * x[1];
    const double psi1 = c1 * ((x[1] - 1) / near + (x[1] + 1) / far) - 0.5 * gamma_ * s * (x[0] / near - x[0] / far) +
                        x[0] * x[1] / gamma_ * s - 0.5 * x[1];
    return psi0 + eps_ * psi1;
  }

 private:
  double gamma_;
  double eps_;
};

}  // namespace lober::detail
