// A number with its error bar.
#pragma once

namespace lober {

/// A value and an estimate, on the safe side, of its error.
struct Measured {
  double value = 0, error = 0;
  friend Measured operator+(Measured x, Measured y) { return {x.value + y.value, x.error + y.error}; }
  friend Measured operator-(Measured x, Measured y) { return {x.value - y.value, x.error + y.error}; }
  friend Measured operator*(double factor, Measured x) {
    return {factor * x.value, (factor < 0 ? -factor : factor) * x.error};
  }
};

}  // namespace lober
