// Melnikov's function: the distance of stable and unstable manifolds to first order in a perturbation.
//
// A planar flow f(x) + eps g(x, t) + O(eps^2) of period T, Hamiltonian without the perturbation, has a connecting orbit
// q(t) at eps = 0, from one saddle to another or back to the same. Then
//
//   M(t0) = integral over all t of f(q(t)) ^ g(q(t), t + t0) dt,   f ^ g = f_1 g_2 - f_2 g_1,
//
// is |f(q(-t0))| times the distance from S to U at q(-t0), at time 0, per eps, positive where U lies on the left of S
// (Melnikov 1963; Guckenheimer & Holmes 1983, section 4.5). Simple zeros are pips, and eps times the integral of M
// between two of them is the area of a lobe, to an error of order eps^2 (Rom-Kedar, Leonard & Wiggins 1990).
//
// No closed form of f, g or q is used here: g is the derivative of the velocity by eps, q consists of the
// local manifolds of both saddles and of a trajectory between them, and the integral is the trapezoidal rule, which
// converges exponentially for analytic integrands that decay at both ends.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober {

/// The flow for a value of eps. It has to be smooth in eps about 0 and have the same period T for all eps.
using FlowFamily = std::function<std::shared_ptr<const Flow>(double eps)>;

/// A zero of Melnikov's function.
struct MelnikovZero {
  double t0 = 0;     ///< in [0, T)
  double slope = 0;  ///< dM/dt0
};

/// The part of M between a zero and the next one.
struct MelnikovLobe {
  double begin = 0, end = 0;  ///< t0; begin < end <= begin + T
  double integral = 0;        ///< integral of M; its negative is the signed area of the lobe per eps (Lobe::area)
};

/// Melnikov's function of a flow.
struct Melnikov {
  double period = 0;  ///< T
  Point from, to;     ///< the saddles at eps = 0
  /// M(t0) = cosines[0] + sum over k >= 1 of cosines[k] cos(2 pi k t0 / T) + sines[k] sin(2 pi k t0 / T).
  std::vector<double> cosines, sines;
  double error = 0;    ///< estimate of the error of M: quadrature, series, and how well the halves of q fit
  double largest = 0;  ///< the largest |M|
  std::vector<MelnikovZero> zeros;  ///< ascending; none where M is zero throughout, to its error, or has one sign
  std::vector<MelnikovLobe> lobes;  ///< from each zero to the next, cyclically

  /// M(t0).
  [[nodiscard]] LOBER_API double at(double t0) const;
  /// Sums of the areas of a period's lobes to first order, each counted as positive: lobes on the left of U and lobes
  /// on its right.
  struct Sides {
    double left = 0, right = 0;  ///< the sum of each side
  };
  /// The sums of both sides for a value of eps.
  [[nodiscard]] LOBER_API Sides lobe_areas(double eps) const;
};

/// Throws UsageError when the flow is not planar and periodic in time or has no Hamiltonian at eps = 0; DataError when
/// the saddles of the connection are not there at eps = 0 or no orbit connects them on the branches it names. About
/// 10^5 evaluations of the vector field.
[[nodiscard]] LOBER_API Melnikov melnikov(const FlowFamily& family, const Connection& connection,
                                          const IntegrationOptions& options = {});

}  // namespace lober
