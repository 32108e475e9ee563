// Many closed curves against many, in memory: areas and counts of all pairs.
//
//   const std::vector<lober::CurveView> monday{c1, c2}, friday{first, second};
//   const lober::OverlapMatrix found = lober::overlap_matrix(monday, friday);
//   for (std::size_t k = found.begin[0]; k < found.begin[1]; ++k)
//     use(found.column[k], found.numbers[0].values[k]);  // the area that c1 shares with those of Friday
//
// Curves whose boxes lie apart are never looked at as a pair. A store, files and all operations: lober/batch.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/curve/curve.hpp"

namespace lober {

/// A number of a pair of curves: an area in squared units of the coordinates, or a count of an overlay.
enum class OverlapMeasure : std::uint8_t {
  intersection,
  union_,
  c1_minus_c2,
  c2_minus_c1,
  symmetric_difference,
  crossings,
  touches,
  shared_arcs
};
/// All measures.
inline constexpr std::array<OverlapMeasure, 8> all_overlap_measures{OverlapMeasure::intersection,
                                                                    OverlapMeasure::union_,
                                                                    OverlapMeasure::c1_minus_c2,
                                                                    OverlapMeasure::c2_minus_c1,
                                                                    OverlapMeasure::symmetric_difference,
                                                                    OverlapMeasure::crossings,
                                                                    OverlapMeasure::touches,
                                                                    OverlapMeasure::shared_arcs};
/// "intersection", "union", ...
[[nodiscard]] LOBER_API std::string_view name(OverlapMeasure measure);
/// The measure of that name. Throws UsageError, with all names.
[[nodiscard]] LOBER_API OverlapMeasure overlap_measure(std::string_view name);
/// Whether it is a number of crossings, touches or shared arcs, and not an area.
[[nodiscard]] constexpr bool is_count(OverlapMeasure measure) {
  return measure >= OverlapMeasure::crossings;
}
/// Whether it is 0 for curves without a common point.
[[nodiscard]] constexpr bool is_zero_apart(OverlapMeasure measure) {
  return measure == OverlapMeasure::intersection || is_count(measure);
}

/// Options of overlap_matrix.
struct OverlapOptions {
  std::vector<OverlapMeasure> measures{OverlapMeasure::intersection};  ///< numbers to keep
  bool check_simple = true;  ///< refuse curves that are not simple; each is checked once
  bool keep_going = false;   ///< a curve or pair that cannot be used is a failure of the result, and nothing is thrown
  Progress progress{};       ///< called with the fraction of the pairs that are done
};

/// The result of overlap_matrix: a sparse matrix by rows, with an entry for each pair of curves whose regions or
/// boundaries have a point in common.
struct OverlapMatrix {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();  ///< no curve
  /// A curve that cannot be used (the other number is `none`), or a pair.
  struct Failure {
    std::size_t row = none, column = none;  ///< numbers of the curves
    std::string message;                    ///< why
  };
  /// A measure of all entries.
  struct Numbers {
    OverlapMeasure measure;      ///< which number
    std::vector<double> values;  ///< one for each entry; NaN for a pair that failed
    std::vector<double> bounds;  ///< bounds on |value - exact area of the polygons|; none for counts
  };

  std::size_t rows = 0, columns = 0;         ///< numbers of curves
  std::vector<std::size_t> begin;            ///< entries of row i: begin[i] to begin[i + 1]
  std::vector<std::uint32_t> column;         ///< the column of each entry, ascending within a row
  std::vector<Numbers> numbers;              ///< in the order of OverlapOptions::measures
  std::array<std::vector<double>, 2> areas;  ///< areas of the curves of each set; NaN for those that failed
  std::size_t pairs = 0;                     ///< number of pairs that were overlaid
  std::vector<Failure> failures;             ///< curves first, then pairs, in order

  /// A measure as rows x columns numbers, row by row: pairs without an entry included, NaN where a curve failed.
  [[nodiscard]] LOBER_API std::vector<double> dense(std::size_t measure) const;
  /// Its bounds likewise; zeros for counts.
  [[nodiscard]] LOBER_API std::vector<double> dense_bounds(std::size_t measure) const;
};

/// Each curve of one set with each of the other: the numbers are those of overlay, bit for bit (but sums of two areas,
/// for curves whose boxes are apart, are rounded twice). Curves stay the caller's. Each is indexed and checked once,
/// about 3 bytes a point; only pairs whose boxes meet are overlaid, small ones side by side, huge ones inside
/// themselves. The same bits for any number of threads. Throws UsageError for an open curve, DataError for one that
/// cannot be used, which names it, Cancelled.
[[nodiscard]] LOBER_API OverlapMatrix overlap_matrix(std::span<const CurveView> first,
                                                     std::span<const CurveView> second,
                                                     const OverlapOptions& options = {});

/// The curves of one set with each other: row and column are both of it. Each pair is overlaid once, the curve with the
/// smaller number being C1, and the entry on the other side of the diagonal follows from it.
[[nodiscard]] LOBER_API OverlapMatrix overlap_matrix(std::span<const CurveView> curves,
                                                     const OverlapOptions& options = {});

}  // namespace lober
