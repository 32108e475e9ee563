// The points where two segments meet, exactly: the common part of contacts of two curves and incidences of one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/base/unfilled.hpp"
#include "kernels/crossing_parameters.hpp"
#include "kernels/predicates.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// The points that two half-open segments a -> b and c -> d share, each with its first end and without its second: one
/// proper crossing, or the first end of both, or the first end of either on the other.
struct PairContacts {
  int rho = 0;             ///< proper crossing: +1 if c -> d passes from right to left of a -> b, else -1
  bool coincide = false;   ///< a == c; no other point is reported then
  bool start1_on = false;  ///< a lies on c -> d
  bool start2_on = false;  ///< c lies on a -> b
  bool one_line = false;   ///< all four points lie on one line
};

/// Exact. Segments of no length meet nothing.
[[nodiscard]] inline PairContacts contacts_of(const Segment& first, const Segment& second, PredicateCounts& counts) {
  const auto [a, b] = first;
  const auto [c, d] = second;
  if (a == b || c == d) return {};
  const int side_c = orient2d(a, b, c, counts), side_d = orient2d(a, b, d, counts);
  if (side_c * side_d > 0) return {};
  const int side_a = orient2d(c, d, a, counts), side_b = orient2d(c, d, b, counts);
  if (side_a * side_b > 0) return {};
  PairContacts found;
  if (side_a * side_b < 0 && side_c * side_d < 0) {
    found.rho = side_d;
    return found;
  }
  found.one_line = side_a == 0 && side_b == 0;
  if (a == c) {
    found.coincide = true;
    return found;
  }
  found.start1_on = side_a == 0 && a != d && on_segment(c, d, a, counts);
  found.start2_on = side_c == 0 && c != b && on_segment(a, b, c, counts);
  return found;
}

/// Computes parameters t1 and t2 of contacts on their two segments, those of proper crossings many at a time.
template <typename Target>
class ParameterBatch {
 public:
  explicit ParameterBatch(double scale) : scale_(scale) {}

  /// `starts1`, `starts2`: the contact is the first end of that segment. `target` is filled in by the next `flush` at
  /// the latest and must stay where it is until then.
  void add(const Segment& first, const Segment& second, bool starts1, bool starts2, Target& target) {
    if (!starts1 && !starts2) {
      crossings_[waiting_] = {first.a, first.b, second.a, second.b};
      target_[waiting_++] = &target;
      if (waiting_ == size) flush();
      return;
    }
    if (!starts1) target.t1 = exact_parameter(first.a, first.b, {second.a, second.a, true});
    if (!starts2) target.t2 = exact_parameter(second.a, second.b, {first.a, first.a, true});
  }

  void flush() {
    exact_ += crossing_parameters(crossings_.data(), waiting_, scale_, parameters_.data());
    for (std::size_t k = 0; k < waiting_; ++k) {
      target_[k]->t1 = parameters_[k].t1;
      target_[k]->t2 = parameters_[k].t2;
    }
    waiting_ = 0;
  }

  /// Crossings too shallow for double-double, so far.
  [[nodiscard]] std::uint64_t exact() const { return exact_; }

 private:
  static constexpr std::size_t size = 256;
  double scale_;
  Unfilled<SegmentCrossing, size> crossings_;
  Unfilled<CrossingParameters, size> parameters_;
  std::array<Target*, size> target_;
  std::size_t waiting_ = 0;
  std::uint64_t exact_ = 0;
};

}  // namespace lober::detail
