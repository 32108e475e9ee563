// Limits for work that makes data instead of reading it.
#pragma once

#include <cstddef>
#include <limits>

namespace lober::detail {

/// Handed to CurveUnit::load and, with the curves, to Operation::run. Work whose size is not known before asks it as it
/// goes; all of it may be called from several threads at the same time.
class Allowance {
 public:
  Allowance() = default;
  Allowance(const Allowance&) = delete;
  Allowance& operator=(const Allowance&) = delete;
  virtual ~Allowance() = default;

  /// Bytes that the work may hold at most: the memory of the queue, so that it does not depend on what else runs.
  [[nodiscard]] virtual std::size_t most() const { return std::numeric_limits<std::size_t>::max(); }
  /// Says how many bytes the work holds in all. Throws DataError when that is more than `most`. An exception thrown
  /// while other work holds the memory is not an Error and has to be let through: the queue then begins the work anew
  /// later.
  virtual void book(std::size_t /*bytes*/) const {}
  /// Throws Cancelled when the queue was stopped: the work is then dropped, not failed.
  virtual void check() const {}
};

}  // namespace lober::detail
