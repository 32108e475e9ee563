// A flow: an autonomous or time-periodic vector field of at most six dimensions, its trajectories, and the planar maps
// that it defines.
//
// Trajectories are integrated by Gragg's method with extrapolation, of order 12, several at a time in the vectors of
// the processor, each with steps chosen by its own errors: a trajectory has the same bits in every batch and on every
// processor. The components of the vector field are compiled into the integrator; calls are virtual once a batch.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "lober/base/export.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober {

inline constexpr int max_flow_dimension = 6;  ///< coordinates of a flow at most

/// Coordinates of a point of phase space; the first dimension() of them count, the others are 0.
using FlowState = std::array<double, max_flow_dimension>;
/// d(coordinate i)/d(coordinate j) at [i][j].
using FlowMatrix = std::array<FlowState, max_flow_dimension>;

/// Two coordinates such that state[q] and factor * state[p] are conjugate: the Hamiltonian H obeys
/// factor dq/dt = dH/d(state[p]) and factor d(state[p])/dt = -dH/dq.
struct ConjugatePair {
  int q = 0;          ///< number of the position
  int p = 1;          ///< number of the momentum
  double factor = 1;  ///< factor of the momentum
};

/// How trajectories are integrated.
struct IntegrationOptions {
  /// Error of a step, for each component: tolerance * (scale + |x| + |dt dx/dt|). The scale is 1 where a coordinate is
  /// of order one or more (0.01 at least) at the start of the trajectory, as for the built-in systems. On trajectories
  /// of fields of one's own (VectorField) with small coordinates only, as in SI units of molecules, it is the largest
  /// |x| that the component has had so far; and where steps are refused again and again the rounding of the velocity is
  /// allowed. Errors of a whole trajectory are some ten times as large on the built-in systems, times the stretching.
  double tolerance = 1e-12;
  /// A trajectory is lost, and its point NaN, when a coordinate exceeds this (systems of one's own: or a thousand times
  /// the farthest edge of their window, if that is more) ...
  double escape = 1e6;
  /// ... or when one step of a map takes more integration steps than this (near singularities) ...
  int max_steps = 20000;
  /// ... or when it takes more time than this before it returns to the section.
  double max_time = 1000;

  /// A hundredth of the tolerance, as far as doubles reach: for derivatives and actions, which need more digits than
  /// points of a curve and are computed for few points.
  [[nodiscard]] IntegrationOptions finer() const {
    IntegrationOptions result = *this;
    result.tolerance = std::min(tolerance, std::max(0.01 * tolerance, 1e-15));
    return result;
  }
};

/// A section state[coordinate] = value, crossed in one direction, and two coordinates on it.
struct Section {
  int coordinate = 0;  ///< number of the coordinate that is constant
  double value = 0;    ///< its value
  /// Sign of d(state[coordinate])/dt at the crossings that count; 0: either (in Flow::to_section only).
  int direction = 1;
  /// The planar map is in these coordinates.
  int chart_x = 1;
  int chart_y = 2;  ///< number of the second coordinate of the map
  /// The coordinate that follows from the energy and the direction of the crossing: the momentum or velocity conjugate
  /// to `coordinate`. The Hamiltonian must be quadratic in it. -1: none (flows of three dimensions).
  int solved = -1;
  /// Only crossings with bound_side * (state[bound_coordinate] - bound) > 0 count; bound_side 0: all.
  int bound_coordinate = 0;
  double bound = 0;    ///< the bound
  int bound_side = 0;  ///< side of the bound that counts
  /// Period of an angle: state[coordinate] = value + k * period is the same section for every whole number k. The flow
  /// must not change when the coordinate is shifted by it. 0: the coordinate is not an angle.
  double period = 0;
};

/// Immutable and safe to use from several threads at the same time.
class LOBER_API Flow {
 public:
  Flow() = default;
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;
  virtual ~Flow() = default;

  /// Number of coordinates.
  [[nodiscard]] virtual int dimension() const = 0;
  /// Period in time; 0 for autonomous flows.
  [[nodiscard]] virtual double period() const = 0;
  /// The velocity at a state and a time.
  [[nodiscard]] virtual FlowState velocity(const FlowState& state, double time) const = 0;
  /// The velocities at states, each at its own time: the bits of `velocity`, at once where a call of a field of one's
  /// own costs much (VectorField::batch). The three spans have one length.
  virtual void velocities(std::span<const FlowState> states, std::span<const double> times,
                          std::span<FlowState> found) const {
    for (std::size_t k = 0; k < states.size(); ++k) found[k] = velocity(states[k], times[k]);
  }
  /// d(velocity)/d(state).
  [[nodiscard]] virtual FlowMatrix jacobian(const FlowState& state, double time) const = 0;
  /// Empty when the flow is not Hamiltonian.
  [[nodiscard]] virtual std::span<const ConjugatePair> conjugate_pairs() const = 0;
  /// Throws UsageError when the flow is not Hamiltonian.
  [[nodiscard]] virtual double hamiltonian(const FlowState& state, double time) const = 0;

  /// Carries each state from time `from` to time `to` (which may be earlier). A lost state becomes NaN.
  virtual void integrate(std::span<FlowState> states, double from, double to, const IntegrationOptions&) const = 0;
  /// Integrates one state, with the derivative of the end with respect to the beginning, by the variational
  /// equations under the same control of errors.
  virtual FlowState integrate_with_derivative(const FlowState& state, double from, double to, FlowMatrix& derivative,
                                              const IntegrationOptions&) const = 0;
  /// Integrates one state, with the integral of p dq over all conjugate pairs. Throws UsageError when the flow is not
  /// Hamiltonian.
  virtual FlowState integrate_with_action(const FlowState& state, double from, double to, double& action,
                                          const IntegrationOptions&) const = 0;
  /// Follows each state to its |crossings|-th crossing of the section after time 0, backward in time when negative. A
  /// crossing at the start does not count. `times`, if not empty, receives the times. The section's coordinate is
  /// exactly its value at the end; the crossing is located to rounding on the step of the integrator that contains it.
  /// Two crossings within one step are found. Returns the work, in tenths of PlanarMap::work.
  virtual std::uint64_t to_section(std::span<FlowState> states, std::span<double> times, const Section& section,
                                   int crossings, const IntegrationOptions&) const = 0;

  /// The map over one period of a flow of two dimensions, from time phase * period(). Its action is the integral of
  /// p dq - H dt. Derivatives and actions of this map and of the next are integrated with options.finer(). Throws
  /// UsageError for other dimensions and for autonomous flows.
  [[nodiscard]] virtual std::unique_ptr<PlanarMap> stroboscopic_map(double phase, const IntegrationOptions&) const = 0;
  /// The first return map to a section of an autonomous flow: of three dimensions, or of four with a Hamiltonian, on
  /// the surface H = energy. The action is the integral of p dq / factor of the chart's pair. A point that the energy
  /// does not reach becomes NaN. Throws UsageError for other flows or a section that does not fit.
  [[nodiscard]] virtual std::unique_ptr<PlanarMap> section_map(const Section& section, double energy,
                                                               const IntegrationOptions&) const = 0;
  /// The state of a point of the section, NaN where the energy does not reach; for the other direction, read the
  /// chart's coordinates.
  [[nodiscard]] virtual FlowState on_section(const Section& section, double energy, Point point) const = 0;
};

}  // namespace lober
