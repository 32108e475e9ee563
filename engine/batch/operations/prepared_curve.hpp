// A curve in memory with whatever jobs need to know about it: found once for all pairs that it occurs in.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "lober/curve/curve.hpp"
#include "lober/overlay/index.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::detail {

/// Requirements of an operation on its curves.
struct Requirements {
  bool index = false;           ///< the box tree
  bool simple = false;          ///< that the curve be simple
  bool closed = false;          ///< that it be closed
  bool discretisation = false;  ///< DiscretisationSums
  Requirements& operator|=(const Requirements& other) {
    index |= other.index;
    simple |= other.simple;
    closed |= other.closed;
    discretisation |= other.discretisation;
    return *this;
  }
  friend bool operator==(const Requirements&, const Requirements&) = default;
};

/// Stays where it is: the index refers to the points.
class PreparedCurve {
 public:
  /// Takes the curve and prepares the required data, for all operations that are going to use it. Nothing is thrown for
  /// a curve that cannot be used: `error` says why. `warning` is kept with it.
  PreparedCurve(std::shared_ptr<const Curve> curve, const Requirements& requirements, std::string warning = {});
  /// A curve that could not even be read.
  explicit PreparedCurve(std::string error) : curve_(std::make_shared<const Curve>()), error_(std::move(error)) {}
  PreparedCurve(const PreparedCurve&) = delete;
  PreparedCurve& operator=(const PreparedCurve&) = delete;

  [[nodiscard]] const Curve& curve() const { return *curve_; }
  [[nodiscard]] const IndexedCurve& index() const { return *index_; }
  [[nodiscard]] const DiscretisationSums& sums() const { return *sums_; }
  /// Why an operation with these requirements, which are among those it was prepared for, cannot use the curve; empty
  /// if it can. Requirements of other operations do not matter.
  [[nodiscard]] const std::string& error(const Requirements& requirements) const;
  [[nodiscard]] const std::string& warning() const { return warning_; }
  [[nodiscard]] std::size_t memory() const;  ///< bytes

 private:
  std::shared_ptr<const Curve> curve_;
  std::optional<IndexedCurve> index_;
  std::optional<DiscretisationSums> sums_;
  /// Why no operation can use it; why those with these requirements cannot.
  std::string error_, not_closed_, not_simple_;
  std::string warning_;
};

}  // namespace lober::detail
