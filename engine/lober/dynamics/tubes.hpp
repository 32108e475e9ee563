// The stable or unstable manifold of a periodic orbit, and where it meets a section.
//
// On the orbit's local section the manifold is a curve P(s) with F(P(s)) = P(lambda s), F the return map
// (dynamics/local_manifold.hpp: a polynomial with a defect near rounding). The trajectories from one fundamental
// segment, reach / lambda <= s <= reach, make up the whole tube, each of them once. So the k-th crossing of any other
// section is a closed curve c(u), 0 <= u <= 1, s = reach lambda^(u - 1), known point by point, and is sampled from the
// flow to a tolerance. Errors of the local manifold shrink on the way, those across the tube by as much as those along
// it grow.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/periodic_orbit.hpp"

namespace lober {

/// A section {state[coordinate] = value} of a flow of two degrees of freedom, in the chart of its other pair.
/// `direction`: that of the crossings that count, 0 for both. Throws UsageError when the coordinate is not a position.
[[nodiscard]] LOBER_API Section position_section(const Flow& flow, int coordinate, double value, int direction);

/// The curve in which a tube meets a section.
struct TubeCurve {
  CurveImage image;       ///< in the section's chart
  int direction = 0;      ///< direction in which its trajectories cross, in forward time; 0: not all alike
  bool cut = false;       ///< image of the part that has not left, closed along a regularising curve; may cross itself
  double cut_off = 0;     ///< for a cut curve: the area that may be lost by closing it
  bool complete = false;  ///< every trajectory gets here, and the curve meets the tolerance
  double area = 0;        ///< area that it encloses, with an error of order h^6; 0 unless complete
  /// Error bar of `area`: for the discretisation, the integration (a few trajectories once more, less accurately) and
  /// the local manifold.
  double area_error = 0;
  /// The part of area_error by integration and local manifold; for a cut curve that of segments that no refinement
  /// shortens.
  double displacement_area = 0;
  double work = 0;           ///< work that it took (PlanarMap::work)
  bool out_of_work = false;  ///< it ends unfinished, at TubeCurveOptions::max_work
  /// Borrows the points.
  [[nodiscard]] ClosedCurve view() const& { return ClosedCurve::borrow(image.points); }
  [[nodiscard]] ClosedCurve view() const&& = delete;
};

/// Options of a curve of a tube.
struct TubeCurveOptions {
  double tolerance = 1e-7;                                    ///< how far the curve may lie from its polygon
  std::size_t max_points = 20'000'000;                        ///< points of the curve at most
  double max_work = std::numeric_limits<double>::infinity();  ///< for the curve (PlanarMap::work)
  Progress progress{};                                        ///< called from the calling thread; tells no fraction
};

/// Immutable, and safe to use from several threads. The flow must outlive it.
class Tube {
 public:
  /// Throws as local_manifold.
  LOBER_API Tube(const Flow& flow, const PeriodicOrbit& orbit, ManifoldSide side, const IntegrationOptions& options);

  /// The orbit that the tube belongs to.
  [[nodiscard]] const PeriodicOrbit& orbit() const { return orbit_; }
  /// Whether the tube is the stable or the unstable one.
  [[nodiscard]] ManifoldSide side() const { return local_.side; }
  /// The local manifold next to the orbit.
  [[nodiscard]] const LocalManifold& local() const { return local_; }

  /// Where the trajectories of a branch, numbered by u in [0, 1], begin.
  LOBER_API void begin(Branch branch, std::span<const double> u, std::span<FlowState> states) const;
  /// Their crossing number k = 1, 2, ... of the section: after they began on the unstable side, before on the stable
  /// one. NaN for those that do not get there. Returns the work, in tenths of PlanarMap::work.
  LOBER_API std::uint64_t crossings(Branch branch, const Section& section, int k, std::span<const double> u,
                                    std::span<FlowState> states) const;
  /// The branch whose trajectories reach the section, the sooner one if both do; none when neither does.
  [[nodiscard]] LOBER_API std::optional<Branch> branch_towards(const Section& section) const;
  /// Crossing number k = 1, 2, ... as a closed curve. `before`: crossing number k - 1, complete, which shows where this
  /// one needs points; none for the first one. Throws Cancelled.
  [[nodiscard]] LOBER_API TubeCurve curve(Branch branch, const Section& section, int k, const TubeCurve* before,
                                          const TubeCurveOptions& options) const;
  /// The area that each of those curves encloses: the orbit's action in units of the section's chart (the integral of
  /// p dq about the tube is the same wherever it is cut, and p dq of the section's own pair is 0 on it).
  [[nodiscard]] LOBER_API double area_by_action(const Section& section) const;

 private:
  [[nodiscard]] int direction_of(Branch branch, const Section& section, int k) const;
  [[nodiscard]] double displacement_area(Branch branch, const Section& section, int k, const CurveImage& image) const;

  const Flow& flow_;
  PeriodicOrbit orbit_;
  IntegrationOptions options_;
  LocalManifold local_;
};

}  // namespace lober
