// One quantity by two independent routes, and whether they agree within their error bars.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "lober/base/error.hpp"
#include "lober/base/export.hpp"

namespace lober {

/// One quantity by two routes.
struct Comparison {
  std::string what;                 ///< the quantity: "T12(3)"
  std::string first_by, second_by;  ///< the routes: "lobes", "boundaries"
  double first = 0, second = 0;     ///< its value by each of them
  double bar = 0;                   ///< sum of both error bars

  /// The distance of the two values.
  [[nodiscard]] double difference() const { return std::fabs(first - second); }
  /// A bar that is NaN allows no difference at all.
  [[nodiscard]] bool agrees() const { return first == second || difference() <= bar; }
};

/// All comparisons of a result, in the order in which they were made.
struct Agreement {
  std::vector<Comparison> comparisons;  ///< in the order in which they were made

  /// Nothing happens when either value is NaN: then there are no two routes.
  void compare(Comparison comparison) {
    if (!std::isnan(comparison.first) && !std::isnan(comparison.second)) comparisons.push_back(std::move(comparison));
  }
  /// Whether all comparisons agree.
  [[nodiscard]] bool agrees() const {
    return std::all_of(comparisons.begin(), comparisons.end(), [](const Comparison& c) { return c.agrees(); });
  }
  /// The comparisons that do not agree.
  [[nodiscard]] std::vector<Comparison> disagreements() const {
    std::vector<Comparison> list;
    std::copy_if(comparisons.begin(), comparisons.end(), std::back_inserter(list),
                 [](const Comparison& c) { return !c.agrees(); });
    return list;
  }
};

/// The error to throw when a result must not pass for a good one; the program throws it after it has printed
/// everything, and ends with exit status 3.
class LOBER_API DisagreementError : public Error {
 public:
  using Error::Error;
};

}  // namespace lober
