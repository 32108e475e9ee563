// The turnstile of a family of maps, value by value of a parameter, and where the flux changes sides.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "lober/transport/transport.hpp"

namespace lober {

/// The member of the family for one value of the parameter.
struct FamilyMember {
  std::shared_ptr<const PlanarMap> map;  ///< the map
  Connection connection;                 ///< the manifolds of its tangle
  Point lattice{};                       ///< as in System
};
/// Called from several threads; may throw Error, which is recorded for that value.
using Family = std::function<FamilyMember(double)>;

/// The turnstile for one value.
struct SweepRow {
  double value = 0;                     ///< value of the parameter
  std::string failure;                  ///< why there is no result; empty if there is one
  Point from, to;                       ///< the saddles
  Point bip;                            ///< q
  double multiplier = 0;                ///< multiplier of the unstable manifold
  std::size_t period = 0;               ///< pips an iterate: the number of lobes of the turnstile
  std::vector<double> areas;            ///< areas of the lobes from f^-1(q) to q by geometry, signed as Lobe::area
  std::vector<double> errors;           ///< estimates of the errors of `areas`
  std::vector<double> areas_by_action;  ///< the areas by action; empty if the map has no action
  /// mu(L12(1)), mu(L21(1)): the areas that leave and enter in one iterate, by geometry, as in TransportBoundary. NaN
  /// where the boundary has no flux: then `remark` says why.
  Measured flux12{}, flux21{};
  std::string remark;  ///< why the boundary has no flux; empty if it has one
  /// Sums of the areas of the lobes that leave and that enter, each counted fully: more than the flux where they
  /// overlap. By geometry, and by action (NaN if the map has none).
  Measured lobe_area12{}, lobe_area21{};
  double lobe_area12_by_action = 0, lobe_area21_by_action = 0;  ///< the same sums by action
  /// W(q) - W(q'), q' the pip half an iterate before q: in a reversible map the other symmetric pip, so that this
  /// crosses zero where the two sides of the turnstile change places. It is the area of a lobe only as long as there
  /// are two pips an iterate. NaN without an action.
  double difference = 0;
  /// Whether the pips are those of the row before, followed from there; else the difference may jump in between, and no
  /// zero is looked for.
  bool follows = false;
};

/// A sign change of the difference between two values next to each other.
struct SweepZero {
  double low = 0, high = 0;  ///< the two values, ascending or descending as they come
  double value = 0;          ///< the zero
  double width = 0;          ///< width of the interval in which the zero is known to lie
  double difference = 0;     ///< the difference that is left there
  int evaluations = 0;       ///< number of evaluations of the difference
  std::string failure;       ///< why it could not be refined: a value without a result, or a jump
};

/// Options of sweep.
struct SweepOptions {
  ManifoldTangleOptions tangle{};  ///< `progress` in it is not used
  bool find_zeros = false;         ///< whether to refine sign changes of the difference
  double zero_tolerance = 1e-10;   ///< relative to the value
  Progress progress{};             ///< called with the fraction of the work on the values that is done
  /// Called with each row as soon as it and all before it are known, in the order of the values, one call at a time;
  /// `follows` is not known yet.
  std::function<void(const SweepRow& row)> on_row{};
};

/// The result of sweep.
struct Sweep {
  std::vector<SweepRow> rows;    ///< in the order of the values
  std::vector<SweepZero> zeros;  ///< in the order of the values
  /// Number of rows without a result.
  [[nodiscard]] LOBER_API std::size_t failures() const;
};

/// Gives one row for each value; values that fail are recorded and the rest goes on. Every 32nd value is computed from
/// scratch, and from there its turnstile is continued to the next one: all rows have the same pip as the bip, however
/// it moves, or an image of it, as long as its orbit is found from value to value. A row may have twice the defect that
/// the local manifolds of that value by itself may have (LocalManifoldOptions::neighbour); areas by action agree to
/// their errors. Where pips can be followed, a sweep of a dozen values or more takes less than a third of the
/// evaluations of the map that separate values take; one at which they come or go about half or all of them. A zero
/// takes about six orbits and one more tangle, which confirms it. Values and zeros are computed in parallel; the same
/// bits for any number of threads. Throws Cancelled.
[[nodiscard]] LOBER_API Sweep sweep(const Family& family, std::span<const double> values,
                                    const SweepOptions& options = {});

}  // namespace lober
