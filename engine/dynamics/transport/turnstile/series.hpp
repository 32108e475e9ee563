// The rows of the table of transport, n by n (private to transport/).
#pragma once

#include <vector>

#include "engine/dynamics/transport/turnstile/insides.hpp"
#include "engine/dynamics/transport/turnstile/partition.hpp"
#include "engine/dynamics/transport/turnstile/turnstile.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail {

/// Rows of the table, n = 1, 2, ..., from the tangles grown so far: as far as their pips reach.
class TransportSeries {
 public:
  /// The tangles must outlive it, or the next call of `extend`. Throws as Turnstile, Partition.
  explicit TransportSeries(const std::vector<Barrier>& barriers);

  /// The same boundaries of tangles that were grown farther.
  void extend(const std::vector<Barrier>& barriers);

  [[nodiscard]] const Partition& partition() const { return partition_; }
  [[nodiscard]] const std::vector<Turnstile>& turnstiles() const { return turnstiles_; }
  /// Whether the tangles reach far enough for the next n.
  [[nodiscard]] bool reaches_next() const;
  /// Row n = 1 at the first call, then the next one each time. Throws DataError beyond the reach.
  [[nodiscard]] TransportStep next();

 private:
  [[nodiscard]] Measured gain(std::size_t c, std::size_t d) const;
  void advance();
  [[nodiscard]] RegionMatrix by_boundaries(int n);

  std::vector<Turnstile> turnstiles_;
  Partition partition_;
  InsidesInCommon insides_;
  int n_ = 0;
  std::vector<Measured> gains_;     // C_cd(n) - C_cd(n - 1), row by row
  std::vector<Measured> enclosed_;  // by each boundary
  std::vector<Measured> drift_;     // int (c o f^-1 - c): zero but for errors
  RegionMatrix total_;
};

}  // namespace lober::detail
