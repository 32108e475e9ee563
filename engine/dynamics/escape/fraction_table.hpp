// The table of escape, measured from the curves of bottlenecks (private to escape/).
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/escape/symmetries.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/transport/escape.hpp"

namespace lober::detail {

/// Escape::table and Escape::agreement of a result, which has the curves while functions of this run.
class FractionTable {
 public:
  FractionTable(const Flow& flow, Escape& result) : flow_(flow), result_(result) {}

  /// Adds the rows of this number of crossings, which are not known yet; with those of one also those of none, of
  /// trajectories that cross against the direction that counts and leave.
  void lay_out_rows(int wanted);
  /// Measures the rows that the curves determine and that have not been reported yet; those of no crossings stay where
  /// anything leaves so. Returns the work.
  double measure();
  /// Compares everything known anew: areas, fractions by two splits and by symmetries, and their sums.
  void compare();

 private:
  struct Split {
    int forward;
    int cut;
    std::size_t points;
  };

  [[nodiscard]] std::vector<Split> splits_of(const EscapeFraction& row) const;
  // The fraction by one split, and its error bar.
  [[nodiscard]] CommonArea fraction(const EscapeFraction& row, int forward, std::atomic<std::uint64_t>& nodes) const;
  void measure(EscapeFraction& row, std::atomic<std::uint64_t>& nodes) const;

  void compare_sums(Agreement& agreement) const;
  void compare_sums_by_exit(Agreement& agreement) const;
  void compare_cut_areas(Agreement& agreement) const;
  void compare_by(const EscapeSymmetry& symmetry, const EscapeFraction& row, Agreement& agreement) const;
  static std::string split_text(int forward, int backward);

  const Flow& flow_;
  Escape& result_;
  std::optional<std::vector<EscapeSymmetry>> symmetries_;
};

}  // namespace lober::detail
