// Transport between the regions that boundaries of tangles bound: the area that leaves a region, iterate by iterate.
//
// R1 is the region inside the boundary B(q) of a tangle, R2 the region on the other side of it; with more tangles there
// are more regions (`Region`). L_ij(1) is the set that the map takes from R_i to R_j in one step: lobes of a turnstile.
// Species i is the fluid that is in region R_i at the start; T_ij(n) is the area of species i in R_j after n steps and
// a_ij(n) = T_ij(n) - T_ij(n - 1). With mu the area and f the map, which preserves area (Rom-Kedar & Wiggins 1990;
// docs/conventions.md, section 10),
//
//   lobe method       a_ij(n) = sum over k of mu(L^i_kj(n)) - mu(L^i_jk(n)), and of those
//                     mu(L^i_kj(n)) = sum over s of the sum over m = 0 ... n - 1 of mu(L_kj(1) n f^m L_is(1)),
//                     less that over m = 1 ... n - 1 of mu(L_kj(1) n f^m L_si(1)),
//
// whatever fluid comes back; the difference a(n + 1) - a(n) is one balance of four sums of overlaps;
//
//   boundary method   T_ij(n) = area(f^n(R_i) n R_j), from overlays of the boundary with its image,
//   particles         T_ij(n) counted, with a statistical bar.
//
// By area preservation f may be applied to both sides of an intersection as often as one likes, so that no lobe is
// followed for longer than half of n. On a cylinder (of a lifted angle), where neighbouring cells are one and the same,
// overlaps are sums over translates.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/base/export.hpp"
#include "lober/base/measured.hpp"
#include "lober/base/progress.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober {

/// A region between boundaries.
struct Region {
  /// Coefficients of the constant 1 and then of each boundary in the function of the region: -1, 0 or 1.
  std::vector<int> coefficients;
  Measured area;        ///< NaN when it is not bounded
  bool bounded = true;  ///< whether its area is finite
};

/// Quantities between regions, row by row: row i, column j for the pair (i + 1, j + 1).
class RegionMatrix {
 public:
  RegionMatrix() = default;
  /// A matrix of zeros for this number of regions.
  explicit RegionMatrix(std::size_t regions) : size_(regions), entries_(regions * regions) {}
  /// Number of regions.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The entry of row i and column j, from 0.
  [[nodiscard]] Measured& operator()(std::size_t i, std::size_t j) { return entries_[i * size_ + j]; }
  /// The entry of row i and column j, from 0.
  [[nodiscard]] const Measured& operator()(std::size_t i, std::size_t j) const { return entries_[i * size_ + j]; }

 private:
  std::size_t size_ = 0;
  std::vector<Measured> entries_;
};

/// mu(L_ij(1) n f^m(L_kl(1))): [0] for ij = 12, [1] for 21; then the same for kl. Lobes that overlap all count.
using TurnstileOverlaps = std::array<std::array<Measured, 2>, 2>;

/// The results for one n, as matrices of regions; NaN where a route gives no value.
struct TransportStep {
  int n = 0;                   ///< number of steps
  RegionMatrix flux;           ///< a_ij(n), by lobes; a_ii too
  RegionMatrix total;          ///< T_ij(n), by lobes; for i = j NaN where the region is not bounded
  RegionMatrix by_boundaries;  ///< T_ij(n)
  RegionMatrix by_particles;   ///< T_ij(n) with one standard deviation; of size 0 without particles
  TurnstileOverlaps overlaps;  ///< mu(L_ij(1) n f^(n-1) L_kl(1)) of the first boundary
};

/// Options of transport.
struct TransportOptions {
  int iterates = 7;                                    ///< rows n = 1 to this number
  double tolerance = 1e-5;                             ///< tolerance of the manifolds, see ManifoldTangleOptions
  std::optional<Point> bip_near{};                     ///< a point near q, of the first tangle
  std::size_t max_points = 20'000'000;                 ///< points of each manifold at most
  double max_work = ManifoldTangleOptions{}.max_work;  ///< for each tangle, as in ManifoldTangleOptions
  double budget = 0;  ///< seconds for all of it, by the clock: results then depend on the machine; 0: max_work
  std::vector<Connection> further{};  ///< connections whose boundaries bound more regions
  Point lattice{};                    ///< as in System: the plane repeats itself after this shift; (0, 0): it does not
  std::uint64_t particles = 0;        ///< particles in each bounded region; 0: none are counted
  std::uint64_t seed = 1;             ///< seed of the random numbers of particles
  Progress progress{};                ///< called with lines about the step being done
  /// Called with each row, without particles, when it is ready, and with all comparisons so far; from the calling
  /// thread.
  std::function<void(const TransportStep&, const Agreement&)> on_step{};
};

/// One tangle and its contribution.
struct TransportBoundary {
  Connection connection;                      ///< the manifolds that bound the region
  std::unique_ptr<ManifoldTangle> manifolds;  ///< the tangle
  double point_error = 0;  ///< how far the manifolds may lie from the true ones by integration and rounding
  /// Area that the boundary encloses; where it runs round a cylinder, between it and the line along the lattice
  /// through the origin, negative below that.
  Measured enclosed;
  Measured flux12, flux21;  ///< mu(L12(1)), mu(L21(1)): areas that leave and enter in one step
  /// Sums of the areas of the lobes from f^-1(q) to q that leave and that enter, each counted fully: more than the flux
  /// where they overlap one another. By geometry, and by action (NaN if the map has none).
  Measured lobe_area12, lobe_area21;
  double lobe_area12_by_action = 0, lobe_area21_by_action = 0;  ///< the same sums by action
};

/// The result of transport.
struct Transport {
  std::vector<TransportBoundary> boundaries;  ///< the boundaries, the first one that of region 1
  std::vector<Region> regions;                ///< the regions R1, R2, ...
  std::vector<TransportStep> steps;           ///< n = 1, 2, ...
  int iterates_a_step = 1;  ///< map iterates; 2 where a saddle has negative multipliers: n counts second iterates
  std::vector<std::string> remarks;  ///< remarks that a user should read
  Agreement agreement;               ///< comparisons of all routes

  /// The tangle of the first boundary.
  [[nodiscard]] const ManifoldTangle& manifolds() const { return *boundaries.front().manifolds; }
};

/// Computes everything from a map: grows the manifolds, finds the turnstiles and computes a_ij(n) and T_ij(n) for n up
/// to options.iterates, or as far as points and work suffice: then a remark says what the next n would take. Throws as
/// grow_tangle does when not even n = 1 is reached, and DataError where the map does not preserve area.
[[nodiscard]] LOBER_API Transport transport(const PlanarMap& map, const Connection& connection,
                                            const TransportOptions& options = {});

/// The same for a system: with its own connection and lattice, and with its further boundaries where those are needed
/// to bound region 1 (options.further, unless it is empty, in their place). Throws UsageError for a system that names
/// no connection, DataError with the reason for one that has none for its parameters.
[[nodiscard]] LOBER_API Transport transport(const System& system, const TransportOptions& options = {});

/// The same from two curves alone, as far as they reach: their tangle, whose period must be known. Without a map there
/// are no particles and no integration error.
struct TransportOfCurves {
  std::vector<Region> regions;                        ///< the regions R1 and R2
  Measured enclosed;                                  ///< area that the boundary encloses
  Measured flux12, flux21, lobe_area12, lobe_area21;  ///< as in TransportBoundary
  std::vector<TransportStep> steps;                   ///< n = 1, 2, ...
  std::string limit;                 ///< why there are fewer rows than were asked for; empty if all are there
  std::vector<std::string> remarks;  ///< remarks that a user should read
  Agreement agreement;               ///< comparisons of both routes
};
/// Gives at most `iterates` rows. Throws DataError when the lobes between the bip and its pre-image are not all there,
/// or the period that was given does not fit them.
[[nodiscard]] LOBER_API TransportOfCurves transport(const Tangle& tangle, int iterates);

}  // namespace lober
