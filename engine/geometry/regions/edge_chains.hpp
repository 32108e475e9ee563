// One or two closed curves as one set of segments (private to regions/).
//
// Segment k of C1 has number k, segment k of C2 number n1 + k: what regions/ does to the segments of a pair it does to
// those of one curve as well.
#pragma once

#include <array>
#include <cstdint>

#include "lober/curve/curve.hpp"

namespace lober::detail {

class EdgeChains {
 public:
  EdgeChains() = default;
  explicit EdgeChains(CurveView c1) : curve_{c1, {}}, second_(count_of(c1)), curves_(1) {}
  EdgeChains(CurveView c1, CurveView c2) : curve_{c1, c2}, second_(count_of(c1)), curves_(2) {}

  [[nodiscard]] int curves() const { return curves_; }
  [[nodiscard]] const CurveView& curve(int number) const { return curve_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] int curve_of(std::uint32_t segment) const { return segment < second_ ? 0 : 1; }
  /// The number of segment 0 of a curve (0 or 1).
  [[nodiscard]] std::uint32_t first_of(int number) const { return number == 0 ? 0 : second_; }
  /// One more than the largest number.
  [[nodiscard]] std::uint32_t segments() const { return second_ + (curves_ == 2 ? count_of(curve_[1]) : 0); }

  [[nodiscard]] Segment segment(std::uint32_t number) const {
    return number < second_ ? curve_[0].segment(number) : curve_[1].segment(number - second_);
  }
  [[nodiscard]] Point start(std::uint32_t number) const {
    return number < second_ ? curve_[0].points[number] : curve_[1].points[number - second_];
  }
  /// The nearest segment onwards along the curve, and back along it, that has a length.
  [[nodiscard]] std::uint32_t next(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t previous(std::uint32_t number) const;

 private:
  static std::uint32_t count_of(const CurveView& curve) { return static_cast<std::uint32_t>(curve.points.size()); }

  std::array<CurveView, 2> curve_;
  std::uint32_t second_ = 0;
  int curves_ = 0;
};

}  // namespace lober::detail
