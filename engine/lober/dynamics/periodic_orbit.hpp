// Rank-1 saddles of Hamiltonian flows of two degrees of freedom, and the periodic orbits in their bottlenecks.
//
// Near an equilibrium with one pair of real and one pair of imaginary eigenvalues, each energy above its own holds one
// unstable periodic orbit (Lyapunov; Moser 1958). It is found on a local section q = q(saddle), q the coordinate along
// which it is longest, as a fixed point of the return map: from the linear orbit by continuation in energy, each time
// corrected by Newton's method. A brake orbit, which runs to and fro between two points of rest, is not a special case:
// between them it crosses the local section at full speed.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober {

/// An equilibrium of rank 1, with the linear flow about it.
struct SaddlePoint {
  FlowState at{};          ///< the equilibrium
  double energy = 0;       ///< energy there
  double rate = 0;         ///< the real eigenvalues are +- rate
  double frequency = 0;    ///< the imaginary eigenvalues are +- i frequency
  FlowState unstable{};    ///< eigenvector of +rate, of length 1, largest component positive
  FlowState centre_cos{};  ///< centre_cos cos(frequency t) - centre_sin sin(frequency t) solves the linear flow
  FlowState centre_sin{};  ///< the other vector of that solution
};

/// The state at a position (in the coordinates q of the two conjugate pairs) whose velocity there is zero: momenta by
/// Newton's method, at once where H is quadratic in them. Throws UsageError for other flows than `saddle_point` takes;
/// DataError when there are no such momenta.
[[nodiscard]] LOBER_API FlowState state_at_rest(const Flow& flow, Point position);

/// The equilibrium near `guess`, by Newton's method. Throws UsageError unless the flow is autonomous, of four
/// dimensions and Hamiltonian; DataError when there is no equilibrium near the guess or it is not a saddle of rank 1.
[[nodiscard]] LOBER_API SaddlePoint saddle_point(const Flow& flow, const FlowState& guess);

/// A periodic orbit about a saddle.
struct PeriodicOrbit {
  SaddlePoint saddle;       ///< the saddle
  double energy = 0;        ///< energy of the orbit
  Section local;            ///< crossed by the orbit once a period
  Point at;                 ///< the point where it crosses, in the chart of `local`: the fixed point of the return map
  FlowState state{};        ///< the same point in phase space
  double residual = 0;      ///< distance of `at` from its image
  double period = 0;        ///< the period in time
  double action = 0;        ///< integral of p dq over the orbit, all pairs
  double action_error = 0;  ///< error bar: its change when integrated less accurately
  double multiplier = 0;    ///< Floquet multiplier > 1; the others are its inverse and 1 twice
  FlowMatrix monodromy{};   ///< derivative of the flow over one period at `state`
  double trace_defect = 0;  ///< trace of the monodromy matrix less the sum of the four multipliers
  std::array<FlowState, 2> turning{};  ///< the states where local.coordinate is least and largest
  bool brake = false;                  ///< whether the orbit is at rest at `turning` (velocities below 1e-9)
  int continuation_steps = 0;          ///< number of steps of the continuation in energy
};

/// The orbit at an energy. Throws UsageError when the energy is not above that of the saddle; DataError when the
/// continuation gets stuck. A few hundred evaluations of the return map.
[[nodiscard]] LOBER_API PeriodicOrbit periodic_orbit(const Flow& flow, const SaddlePoint& saddle, double energy,
                                                     const IntegrationOptions& options);

/// `count` states at equal times along the orbit, from `state` on: the first half integrated forwards, the rest
/// backwards, as the orbit is unstable. Each is integrated from `state` by itself, over half a period at most.
[[nodiscard]] LOBER_API std::vector<FlowState> states_along(const Flow& flow, const PeriodicOrbit& orbit,
                                                            std::size_t count, const IntegrationOptions& options);

}  // namespace lober
