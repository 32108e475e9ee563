// Escape from a potential well through bottlenecks: the fraction of the trajectories entering by one that leave by
// another, and when.
//
// The well lies between the periodic orbits of its bottlenecks. Trajectories that enter by bottleneck i cross the
// section first inside a closed curve E_i, cut from the orbit's unstable tube; those about to leave by bottleneck j
// cross it last inside X_j, cut from the stable tube. With f the map to the next crossing, in either direction,
//
//   F_ij(m) = area(f^m(E_i) n X_j) / area(E_i) = area(f^a(E_i) n f^-b(X_j)) / area(E_i),   a + b = m,
//
// since f preserves area (in the conjugate pair of the section's chart) and energy is the same for all. Everything in
// E_i is equally likely. f^a(E_i) is a closed curve as long as f^k(E_i), k < a, meets no exit; then part of it is gone
// and the image of the rest is cut: its ends wind about E_j without end. Splits are chosen so that both curves are
// whole. No symmetry is assumed or used.
//
//   const lober::System system = lober::make_system("capsize");
//   const lober::Escape result = lober::escape(*system.flow, *system.section, 0.25307, system.saddles);
//   for (const lober::EscapeFraction& entry : result.table) use(entry.fraction, entry.error);
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/dynamics/tubes.hpp"

namespace lober {

struct Escape;

/// Why the table ends.
enum class EscapeStop : std::uint8_t {
  done,      ///< all n asked for
  points,    ///< the next images need more than EscapeOptions::max_points
  work,      ///< they take more than EscapeOptions::max_work
  budget,    ///< they are expected to end after EscapeOptions::budget seconds, or did not end by then
  lost,      ///< trajectories could not be followed
  cancelled  ///< by `progress` or a CancellationScope, after some rows were known
};

/// Options of escape and bottlenecks.
struct EscapeOptions {
  int crossings = 4;        ///< n goes up to this
  double tolerance = 1e-6;  ///< tolerance of curves, in units of the square root of the area of the smallest E_i
  double strip = 1e-6;      ///< area cut off where an image is cut, in units of the smallest E_i (cut_images.hpp)
  IntegrationOptions integration{.tolerance = 1e-13, .max_time = 200};  ///< how trajectories are integrated
  /// Points of one curve. The table ends before an image that is expected to need more, or turns out to.
  std::size_t max_points = 2'000'000;
  /// Work that all curves may take, in evaluations of the vector field (PlanarMap::work); a point where cut curves
  /// cross counts as fifty of these. The table ends before images that are expected to need more, and where curves turn
  /// out to. Some 40 s of one core. Not with `budget`.
  double max_work = 1e9;
  /// Seconds by the clock instead: results then depend on the machine; 0: max_work. The table ends before images that
  /// are expected to end later; images that were expected to end in time are broken off a twentieth later. Orbits and
  /// first curves have five seconds at least, and a minute without a budget.
  double budget = 0;
  Progress progress{};  ///< called with the fraction done, as far as it can be predicted, and the step being done
  /// Called for each n = 1, 2, ... once its rows are known: those of `table` with that number of crossings. Called from
  /// the calling thread; Escape::table holds the rows up to n.
  std::function<void(const Escape& so_far, int n)> rows_known;
};

/// A bottleneck and its curves on the section.
struct Bottleneck {
  PeriodicOrbit orbit;                                             ///< the periodic orbit
  Branch entry_branch = Branch::plus, exit_branch = Branch::plus;  ///< branches of the tubes, towards the section
  double multiplier = 0;         ///< multiplier of the orbit by the local manifold of its unstable tube
  double defect_across = 0;      ///< the larger defect of both local manifolds
  double area = 0;               ///< area of E and X, by action
  double area_error = 0;         ///< error bar of `area`
  std::vector<TubeCurve> entry;  ///< E, f(E), f^2(E), ...
  std::vector<TubeCurve> exit;   ///< X, f^-1(X), ...
  /// The largest |area of a curve / `area` - 1|, complete curves only.
  double area_defect = 0;
};

/// A row of the table: the fraction of what enters by one bottleneck that leaves by another.
struct EscapeFraction {
  std::size_t entry = 0, exit = 0;  ///< numbers of bottlenecks
  int crossings = 0;                ///< n: crossings of the section in its direction, until the bottleneck
  int iterates = 0;                 ///< m: iterates of f, from E to X
  double fraction = std::numeric_limits<double>::quiet_NaN();  ///< F; NaN where no split has whole curves
  double error = std::numeric_limits<double>::quiet_NaN();     ///< estimate: discretisation, and the defect of areas
  int forward = 0, backward = 0;                               ///< a, b
  bool cut = false;                                            ///< part of one of the two curves had left already
  /// The fraction from another split; NaN if there is none.
  double other = std::numeric_limits<double>::quiet_NaN();
  double other_error = std::numeric_limits<double>::quiet_NaN();  ///< error bar of `other`
  int other_forward = 0, other_backward = 0;                      ///< a and b of the other split
  /// Whether the fraction is a number.
  [[nodiscard]] bool is_known() const { return fraction == fraction; }
};

/// The result of escape.
struct Escape {
  double energy = 0;                    ///< energy of the trajectories
  Section section;                      ///< its direction is the one that n counts
  std::vector<Bottleneck> bottlenecks;  ///< ordered by their saddle's coordinate across the section, ascending
  /// Saddles of rank 1 below the energy that are not bottlenecks here, from a search on a grid about the bottlenecks:
  /// trajectories that leave the well by these count as not left.
  std::vector<SaddlePoint> also_open;
  /// Ordered by entry, exit, m; 1 <= n <= options.crossings, and n = 0 where trajectories leave before the first
  /// crossing that counts.
  std::vector<EscapeFraction> table;
  int crossings = 0;                    ///< n up to which the table goes
  EscapeStop stop = EscapeStop::done;   ///< why it does not go further
  double points_ahead = 0;              ///< points that the next image was expected to need where it stopped
  double work_spent = 0;                ///< work of all images so far
  double work_ahead = 0;                ///< expected work of the next images; 0: they were broken off
  double seconds_spent = 0;             ///< seconds by the clock of all images so far
  double seconds_ahead = 0;             ///< expected seconds of the next images; 0: they were broken off
  double largest_split_difference = 0;  ///< the largest |fraction - other|
  /// Areas of the tubes' curves by their points and by action; fractions by two splits; fractions that symmetries of
  /// the well make equal.
  Agreement agreement;
};

/// Orbits and first curves only: each Bottleneck has one curve E and one X. Here the section may count one direction
/// or both (direction 0), and be bounded. Throws as `escape` does.
[[nodiscard]] LOBER_API std::vector<Bottleneck> bottlenecks(const Flow& flow, const Section& section, double energy,
                                                            std::span<const FlowState> saddles,
                                                            const EscapeOptions& options = {});

/// The table, n by n, as far as it is affordable (options.max_points, max_work or budget) and trajectories can be
/// followed. `saddles` holds a point near each saddle of rank 1 that bounds the well. Throws UsageError for a section
/// that is not across a coordinate of position, has no direction or is bounded; DataError when an orbit or tube cannot
/// be found within the budget, a tube crosses the section in both directions, or one runs to infinity where it should
/// enter the well; Cancelled before any row is known. The
/// same bits for any number of threads, as long as no budget ends it. Images multiply by about the same factor
/// each time, and with them time and memory.
[[nodiscard]] LOBER_API Escape escape(const Flow& flow, const Section& section, double energy,
                                      std::span<const FlowState> saddles, const EscapeOptions& options = {});

/// "the fraction from bottleneck 1 to 2 after crossing 3"
[[nodiscard]] LOBER_API std::string name(const EscapeFraction& row);
/// The area of each complete curve by its points and by action.
LOBER_API void compare_areas(std::span<const Bottleneck> bottlenecks, Agreement& agreement);

/// The fractions of one entry, summed up to n crossings: the fraction that has left by each exit, and the fraction that
/// has not.
struct Survival {
  int crossings = 0;         ///< n up to which both tables go
  std::vector<double> left;  ///< fraction by each exit
  double remains = 1;  ///< 1 - sum of left; where Escape::also_open lists saddles, part of it may have left by them
  double error = 0;    ///< sum of the error bars
};
/// The survival for n = 1, 2, ... as far as all fractions are known.
[[nodiscard]] LOBER_API std::vector<Survival> survival(const Escape& result, std::size_t entry);

}  // namespace lober
