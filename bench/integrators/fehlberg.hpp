// The coefficients of Fehlberg's pair of orders 7 and 8, as exact fractions in any floating-point type.
#pragma once

#include <string_view>

namespace lober::bench {

/// Carried on with order 8; the error is that of order 7 (Fehlberg 1968, NASA TR R-287).
template <typename R>
struct FehlbergTable {
  static constexpr int stages = 13;
  static constexpr R nodes[stages] = {0,        R(2) / 27, R(1) / 9, R(1) / 6, R(5) / 12, R(1) / 2, R(5) / 6,
                                      R(1) / 6, R(2) / 3,  R(1) / 3, 1,        0,         1};
  static constexpr R a[stages][stages] = {
      {},
      {R(2) / 27},
      {R(1) / 36, R(1) / 12},
      {R(1) / 24, 0, R(1) / 8},
      {R(5) / 12, 0, R(-25) / 16, R(25) / 16},
      {R(1) / 20, 0, 0, R(1) / 4, R(1) / 5},
      {R(-25) / 108, 0, 0, R(125) / 108, R(-65) / 27, R(125) / 54},
      {R(31) / 300, 0, 0, 0, R(61) / 225, R(-2) / 9, R(13) / 900},
      {2, 0, 0, R(-53) / 6, R(704) / 45, R(-107) / 9, R(67) / 90, 3},
      {R(-91) / 108, 0, 0, R(23) / 108, R(-976) / 135, R(311) / 54, R(-19) / 60, R(17) / 6, R(-1) / 12},
      {R(2383) / 4100, 0, 0, R(-341) / 164, R(4496) / 1025, R(-301) / 82, R(2133) / 4100, R(45) / 82, R(45) / 164,
       R(18) / 41},
      {R(3) / 205, 0, 0, 0, 0, R(-6) / 41, R(-3) / 205, R(-3) / 41, R(3) / 41, R(6) / 41},
      {R(-1777) / 4100, 0, 0, R(-341) / 164, R(4496) / 1025, R(-289) / 82, R(2193) / 4100, R(51) / 82, R(33) / 164,
       R(12) / 41, 0, 1}};
  static constexpr R b[stages] = {0,         0,          0,          0, 0,           R(34) / 105, R(9) / 35,
                                  R(9) / 35, R(9) / 280, R(9) / 280, 0, R(41) / 840, R(41) / 840};
};

struct Fehlberg : FehlbergTable<double> {
  static constexpr std::string_view name = "Fehlberg 7(8)";
  static constexpr int estimates = 1;
  static constexpr int error_power = 8;  ///< the estimate falls with this power of the step
  static constexpr double errors[estimates][stages] = {
      {41.0 / 840, 0, 0, 0, 0, 0, 0, 0, 0, 0, 41.0 / 840, -41.0 / 840, -41.0 / 840}};
};

}  // namespace lober::bench
