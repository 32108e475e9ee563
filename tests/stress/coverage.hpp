// How often a stated bound holds and how much larger than the error it is, for one kind of case.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/oracle/exact_number.hpp"

namespace lober::stress {

/// The value of a sorted, non-empty list below which the given fraction lies (nearest rank).
[[nodiscard]] double quantile(const std::vector<double>& sorted, double fraction);

class Coverage {
 public:
  /// One area: what was computed, the bound stated with it, and the exact one. Whether the bound holds.
  bool add(double value, double bound, const oracle::Rational& exact);
  void add(const Coverage& other);
  void sort();

  [[nodiscard]] std::size_t areas() const { return areas_; }
  [[nodiscard]] std::size_t inside() const { return inside_; }
  [[nodiscard]] std::size_t exact() const { return exact_; }  ///< areas without any error
  /// bound / |error|, where there is an error and it is not one of underflow.
  [[nodiscard]] const std::vector<double>& looseness() const { return looseness_; }
  /// bound / (area 2^-53), where the area is not 0: the best bound on rounding to double gives 1/2 to 1.
  [[nodiscard]] const std::vector<double>& size() const { return size_; }

  /// A line of a table and the lines above it. Requires sort().
  [[nodiscard]] std::string row(const std::string& name) const;
  [[nodiscard]] static std::string heading(const std::string& name);

 private:
  std::size_t areas_ = 0, inside_ = 0, exact_ = 0;
  std::vector<double> looseness_, size_;
};

}  // namespace lober::stress
