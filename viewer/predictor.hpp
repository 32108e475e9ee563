// Where the next point of a curve is expected, given the points before it. viewer/page/predictor.js computes the same,
// operation by operation: both have to agree to the last bit.
#pragma once

#include <array>

namespace lober::viewer {

/// Position and its first three derivatives, over the factorials, of one or two coordinates at the last point, as
/// functions of a parameter in which points lie one apart; found by recursive least squares with a fading memory
/// (Morrison, Introduction to Sequential Smoothing and Prediction, 1969), as noise of points would be magnified by
/// differences of high order. O(1) for each point.
class Predictor {
 public:
  static constexpr int ways = 8;  ///< of prediction: degrees of the polynomial, and how fast it forgets

  /// The coordinate `steps` after the last point; 1: the next one, if it is as far as the last one was. Not NaN.
  [[nodiscard]] double at(int axis, double steps) const;

  /// The number of steps after which the coordinate has a value; 1 if none is found between 1/8 and 8.
  [[nodiscard]] double steps_to(int axis, double value) const;

  /// The coordinate that changes faster.
  [[nodiscard]] int primary() const;

  /// Takes a point that lies `steps` after the last one; from then on, that is one step. Both coordinates; of a series
  /// with one only, the other is 0.
  void add(const std::array<double, 2>& point, double steps, int way);

 private:
  std::array<std::array<double, 4>, 2> taylor_{};
  int points_ = 0;  // that were added, up to 4
};

}  // namespace lober::viewer
