// A vector field of one's own, computed for many points at a time, and the flow that is made of it: trajectories,
// return maps, escape and levels as for the built-in systems.
//
//   class Centre final : public lober::VectorField {
//    public:
//     int dimension() const override { return 2; }
//     void velocities(std::size_t count, const double* x, const double* t, double* dxdt) const override {
//       for (std::size_t k = 0; k < count; ++k) {
//         dxdt[k] = x[count + k];
//         dxdt[count + k] = -x[k];
//       }
//     }
//   };
//   const std::shared_ptr<const lober::Flow> flow = lober::make_flow(std::make_shared<Centre>());
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>

#include "lober/base/export.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober {

/// dx/dt = velocity(x, t). Coordinate i of point number k of `count` is x[i * count + k], and so for velocities; each
/// point has its own time t[k]. The values at a point must not depend on the others, bit for bit; NaN stands for a
/// value that does not exist. All functions are called from several threads at the same time, and may throw.
class LOBER_API VectorField {
 public:
  VectorField() = default;
  VectorField(const VectorField&) = delete;
  VectorField& operator=(const VectorField&) = delete;
  virtual ~VectorField() = default;

  /// Number of coordinates, 1 to max_flow_dimension.
  [[nodiscard]] virtual int dimension() const = 0;
  /// Period in time; 0 for an autonomous field, which is not to look at times.
  [[nodiscard]] virtual double period() const { return 0; }
  /// The velocities of `count` points.
  virtual void velocities(std::size_t count, const double* x, const double* t, double* dxdt) const = 0;
  /// d(velocity i)/d(x j) of point k at jacobian[(i * dimension() + j) * count + k]. Unless it is overridden, central
  /// differences of order 4 with steps of a thousandth of min(1 + |x|, extent()), which are good to some twelve digits;
  /// then derivatives of maps are good to six or more.
  virtual void jacobians(std::size_t count, const double* x, const double* t, double* jacobian) const;
  /// Whether `jacobians` is overridden by formulas.
  [[nodiscard]] virtual bool has_jacobian() const { return false; }
  /// Pairs of conjugate coordinates; empty for a field that is not Hamiltonian.
  [[nodiscard]] virtual std::span<const ConjugatePair> conjugate_pairs() const { return {}; }
  /// The Hamiltonian of `count` points, where there are conjugate pairs. Throws UsageError unless it is overridden.
  virtual void hamiltonians(std::size_t count, const double* x, const double* t, double* h) const;

  /// The number of points that are worth a call of `velocities`: 1 for a function of one point, 8 for a loop that the
  /// compiler turns into vector instructions, thousands where a call costs much, as that of an interpreter does.
  [[nodiscard]] virtual std::size_t batch() const { return 1; }
  /// The size of the region of interest, which knows the unit of the coordinates: PlanarMap::unit follows from it, and
  /// errors of integration are judged by that.
  [[nodiscard]] virtual double extent() const { return std::numeric_limits<double>::infinity(); }
};

/// The flow of a field, which stays alive as long as the flow. Throws UsageError for a dimension that is not 1 to
/// max_flow_dimension and for conjugate pairs of coordinates beyond it.
[[nodiscard]] LOBER_API std::shared_ptr<const Flow> make_flow(std::shared_ptr<const VectorField> field);

/// The planar map of a field.
struct FieldMap {
  double phase = 0;   ///< start of the map of a field that is periodic in time and has two coordinates, in periods
  double energy = 0;  ///< energy on the section of a Hamiltonian field of four coordinates
};

/// Completes a system whose flow is that of a field: `described` has all but flow and map, its name and window at
/// least. The map is that of a period of a periodic field of two coordinates; the first return to described.section,
/// where it has one, of an autonomous field of three coordinates or a Hamiltonian one of four; else there is none. A
/// trajectory is lost a thousand times as far as the farthest edge of the window, unless `options` says otherwise.
/// Throws UsageError for a section that does not fit or a negative period, DataError where functions do not belong
/// together: at some points of the window Jacobian, Hamiltonian and the velocities of several points are compared with
/// the velocity.
[[nodiscard]] LOBER_API System make_system(std::shared_ptr<const VectorField> field, System described,
                                           const FieldMap& map = {}, const IntegrationOptions& options = {});

}  // namespace lober
