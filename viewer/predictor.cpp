#include "viewer/predictor.hpp"

#include <cmath>
#include <cstddef>

namespace lober::viewer {
namespace {

using Gains = std::array<double, 4>;  // share of what was unexpected that each coefficient takes

// With memory 0 the polynomial goes through the last degree + 1 points.
constexpr Gains gains_of(int degree, double memory) {
  const double m = memory, c = 1 - m;
  switch (degree) {
    case 0:
      return {c, 0, 0, 0};
    case 1:
      return {1 - m * m, c * c, 0, 0};
    case 2:
      return {1 - m * m * m, 1.5 * (c * c) * (1 + m), 0.5 * (c * c * c), 0};
    default:
      return {1 - m * m * m * m, c * c * (11 + 14 * m + 11 * (m * m)) / 6, c * c * c * (1 + m), c * c * c * c / 6};
  }
}

constexpr std::array<Gains, Predictor::ways> gains{gains_of(0, 0.75), gains_of(1, 0),  gains_of(2, 0),
                                                   gains_of(2, 0.5),  gains_of(3, 0),  gains_of(3, 0.3),
                                                   gains_of(3, 0.5),  gains_of(3, 0.7)};
constexpr std::array<Gains, 4> first_gains{gains_of(0, 0), gains_of(1, 0), gains_of(2, 0), gains_of(3, 0)};

}  // namespace

double Predictor::at(int axis, double steps) const {
  const auto& c = taylor_[static_cast<std::size_t>(axis)];
  const double value = c[0] + steps * (c[1] + steps * (c[2] + steps * c[3]));
  return std::isnan(value) ? 0 : value;
}

double Predictor::steps_to(int axis, double value) const {
  const auto& c = taylor_[static_cast<std::size_t>(axis)];
  double steps = 1;
  for (int k = 0; k < 2; ++k) {  // by Newton's method; curves bend little from point to point
    steps += (value - at(axis, steps)) / (c[1] + steps * (2 * c[2] + 3 * steps * c[3]));
  }
  return steps > 0.125 && steps < 8 ? steps : 1;
}

int Predictor::primary() const {
  return std::fabs(taylor_[1][1]) > std::fabs(taylor_[0][1]) ? 1 : 0;
}

void Predictor::add(const std::array<double, 2>& point, double steps, int way) {
  const Gains& gain =
      points_ < 4 ? first_gains[static_cast<std::size_t>(points_)] : gains[static_cast<std::size_t>(way)];
  if (points_ < 4) ++points_;
  bool valid = true;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    auto& c = taylor_[axis];
    const double c1 = c[1] * steps, c2 = c[2] * (steps * steps), c3 = c[3] * (steps * steps * steps);
    const double expected = c[0] + c1 + c2 + c3, error = point[axis] - expected;
    c = {expected + gain[0] * error, c1 + 2 * c2 + 3 * c3 + gain[1] * error, c2 + 3 * c3 + gain[2] * error,
         c3 + gain[3] * error};
    valid = valid && std::isfinite(c[0] + c[1] + c[2] + c[3]);
  }
  if (valid) return;
  points_ = 1;
  for (std::size_t axis = 0; axis < 2; ++axis) taylor_[axis] = {std::isfinite(point[axis]) ? point[axis] : 0, 0, 0, 0};
}

}  // namespace lober::viewer
