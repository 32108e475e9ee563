// The regions that several boundaries make of the plane, and quantities between regions from quantities between
// boundaries.
//
// Let c be the function that is 1 inside boundary c. Boundaries do not cross, so that each region is what lies inside
// one of them and outside those nested in it; what lies inside none is a region too. The function of a region is a sum
// of these functions and, for the last kind, of the constant 1; so whatever is bilinear in such functions, the area of
// species i in region j above all, follows from the same quantity between boundaries.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/dynamics/transport/tangles/barrier.hpp"

namespace lober::detail {

class Partition {
 public:
  /// R1 lies inside the first boundary, R2 on the other side of it; the rest follows in the order of the boundaries.
  /// The lower end of a cylinder has no area. Throws DataError when boundaries cross.
  explicit Partition(std::span<const Barrier> barriers);

  [[nodiscard]] const std::vector<Region>& regions() const { return regions_; }
  [[nodiscard]] std::size_t size() const { return regions_.size(); }
  /// The common area of the insides of boundaries c and d.
  [[nodiscard]] Measured at_rest(std::size_t c, std::size_t d) const { return at_rest_[c * areas_.size() + d]; }

  /// The sum over c, d of the coefficients of i and j times quantity(c, d), where 0 stands for the constant 1 and
  /// k > 0 for boundary k - 1. Pairs without a coefficient are not asked for.
  [[nodiscard]] Measured combine(std::size_t i, std::size_t j,
                                 const std::function<Measured(std::size_t, std::size_t)>& quantity) const;

 private:
  std::vector<Region> regions_;
  std::vector<Measured> areas_;    // inside each boundary
  std::vector<Measured> at_rest_;  // row by row
};

}  // namespace lober::detail
