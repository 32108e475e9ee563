// One scan of a box for fixed points.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/stopwatch.hpp"
#include "engine/dynamics/fixed_points/displacement_grid.hpp"
#include "engine/dynamics/fixed_points/half_way.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// The options of scans of a box: the extent is that of the box at most. Throws UsageError for options or a box that
/// make no sense.
[[nodiscard]] FixedPointOptions options_of_scan(const Rectangle& box, const FixedPointOptions& given);

/// The work that a search may still take: what the map has counted since, or the time.
class SearchAllowance {
 public:
  /// `half_way`: that of the same search.
  SearchAllowance(const PlanarMap& map, const HalfWayMap& half_way, const FixedPointOptions& options)
      : map_(map), half_way_(half_way), options_(options), begun_(all_work()) {}
  /// Whether so much more work fits in.
  [[nodiscard]] bool has(double work) const {
    const double done = static_cast<double>(all_work() - begun_);
    if (!(options_.budget > 0)) return done + work <= options_.max_work;
    const double seconds = watch_.seconds(), a_unit = done > 0 ? seconds / done : 0;
    return seconds + a_unit * work <= options_.budget;
  }
  /// A part of all of it, as work.
  [[nodiscard]] double part(double share) const {
    if (!(options_.budget > 0)) return share * options_.max_work;
    const double done = static_cast<double>(all_work() - begun_), seconds = watch_.seconds();
    return seconds > 0 && done > 0 ? share * options_.budget * done / seconds : std::numeric_limits<double>::infinity();
  }

 private:
  [[nodiscard]] std::uint64_t all_work() const {
    const std::uint64_t half = half_way_.counts_apart() ? half_way_.work() + half_way_.work_of_derivatives() : 0;
    return map_.work() + map_.work_of_derivatives() + half;
  }

  const PlanarMap& map_;
  const HalfWayMap& half_way_;
  const FixedPointOptions& options_;
  std::uint64_t begun_;
  Stopwatch watch_;
};

/// The displacements of one scan: half way, where that helps, and those of the map itself where some are missing there.
/// Where all points of the grid can be followed both ways, seeds of the map itself add none but far more stretched
/// ones.
class ScanGrids {
 public:
  ScanGrids(const PlanarMap& map, const HalfWayMap& half_way, const Rectangle& box, const FixedPointOptions& options)
      : map_(map), half_way_(half_way) {
    if (half_way.helps(options.period)) halves_.emplace(half_way, box, options);
    if (!halves_ || !halves_->all_have_images()) whole_.emplace(map, box, options);
  }
  /// Each may be null, not both.
  [[nodiscard]] const DisplacementGrid* halves() const { return halves_ ? &*halves_ : nullptr; }
  [[nodiscard]] const DisplacementGrid* whole() const { return whole_ ? &*whole_ : nullptr; }
  /// The diagonal of a cell.
  [[nodiscard]] double cell() const { return (whole_ ? whole_ : halves_)->cell(); }
  /// The map of these whose displacements have turns to be counted: the one with images of all points of the grid. Null
  /// where neither has.
  [[nodiscard]] const PlanarMap* with_all_images() const {
    if (!whole_) return &half_way_;
    return whole_->all_have_images() ? &map_ : nullptr;
  }

 private:
  const PlanarMap& map_;
  const HalfWayMap& half_way_;
  std::optional<DisplacementGrid> halves_, whole_;
};

/// The points that Newton's method finds in the box, sorted by period, x, y: from the seeds of these grids, with their
/// images in the box. With an allowance, from the seeds before it ends.
[[nodiscard]] std::vector<FixedPoint> scan(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options,
                                           const ScanGrids& grids, const HalfWayMap& half_way,
                                           const SearchAllowance* allowance = nullptr);

/// Adds those that are not among the points yet, sorted by period, x, y; where two are the same to within their
/// uncertainties, the one of the smaller period and residual stays. Errors are judged as FixedPointOptions::extent
/// says.
void add_points(std::vector<FixedPoint>& points, std::span<const FixedPoint> more, double extent);

/// The points whose period divides options.period, each found by the equation for its own: that for all of
/// options.period is degenerate where such a point is about to bifurcate, and Newton's method may not converge to it.
[[nodiscard]] std::vector<FixedPoint> scan_for_smaller_periods(const PlanarMap& map, const Rectangle& box,
                                                               const FixedPointOptions& options,
                                                               const HalfWayMap& half_way,
                                                               const SearchAllowance* allowance = nullptr);

/// Whether the degenerate ones among these points are not isolated, but lie on a curve or in an area of fixed points:
/// Newton's method then ends at further ones between them. `cell`: the diagonal of a cell of the scan that found them.
[[nodiscard]] bool fill_a_curve(const PlanarMap& map, const std::vector<FixedPoint>& points,
                                const FixedPointOptions& options, double cell);

}  // namespace lober::detail
