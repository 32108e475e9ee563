// A number with its error bar.
#pragma once

namespace lober {

/// A value and an estimate, on the safe side, of its error.
struct Measured {
  double value = 0, error = 0;  ///< the value, and its error bar
  /// The sum; error bars add up.
  friend Measured operator+(Measured x, Measured y) { return {x.value + y.value, x.error + y.error}; }
  /// The difference; error bars add up.
  friend Measured operator-(Measured x, Measured y) { return {x.value - y.value, x.error + y.error}; }
  /// A multiple, with that of the error bar.
  friend Measured operator*(double factor, Measured x) {
    return {factor * x.value, (factor < 0 ? -factor : factor) * x.error};
  }
};

}  // namespace lober
