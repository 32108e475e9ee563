// Where trajectories lead, to more digits than a double has.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "bench/integrators/fehlberg.hpp"

namespace lober::bench {

/// A long double that a field takes for its kind of number: functions of it are found by its name.
struct Precise {
  long double v;

  Precise() = default;
  Precise(double value) : v(value) {}  // NOLINT: a number is a number
  explicit Precise(long double value) : v(value) {}

  friend Precise operator+(Precise a, Precise b) { return Precise(a.v + b.v); }
  friend Precise operator-(Precise a, Precise b) { return Precise(a.v - b.v); }
  friend Precise operator*(Precise a, Precise b) { return Precise(a.v * b.v); }
  friend Precise operator/(Precise a, Precise b) { return Precise(a.v / b.v); }
  friend Precise operator-(Precise a) { return Precise(-a.v); }
  friend Precise square_root(Precise a) { return Precise(std::sqrt(a.v)); }
};

template <typename Field>
using PreciseState = std::array<Precise, static_cast<std::size_t>(Field::dimension)>;

/// By Fehlberg's method with `steps` equal steps. Forcing is that of doubles, whose errors are as good as random and
/// average out over the steps.
template <typename Field>
PreciseState<Field> precise_end(const Field& field, const std::array<double, Field::dimension>& from, double span,
                                int steps) {
  using Table = FehlbergTable<long double>;
  constexpr std::size_t size = Field::dimension;
  PreciseState<Field> x;
  for (std::size_t i = 0; i < size; ++i) x[i] = from[i];
  const long double h = static_cast<long double>(span) / steps;
  for (int step = 0; step < steps; ++step) {
    PreciseState<Field> slopes[Table::stages];
    for (std::size_t s = 0; s < Table::stages; ++s) {
      PreciseState<Field> at = x;
      for (std::size_t i = 0; i < size; ++i) {
        long double sum = 0;
        for (std::size_t k = 0; k < s; ++k) sum += Table::a[s][k] * slopes[k][i].v;
        at[i].v += h * sum;
      }
      double force[Field::forcings + 1];
      field.forcing(static_cast<double>((step + Table::nodes[s]) * h), force);
      Precise precise_force[Field::forcings + 1];
      for (std::size_t f = 0; f + 1 < std::size(precise_force); ++f) precise_force[f] = force[f];
      field.velocity(at.data(), slopes[s].data(), precise_force);
    }
    for (std::size_t i = 0; i < size; ++i) {
      long double sum = 0;
      for (std::size_t s = 0; s < Table::stages; ++s) sum += Table::b[s] * slopes[s][i].v;
      x[i].v += h * sum;
    }
  }
  return x;
}

struct ErrorSizes {
  double largest = 0, rms = 0;
};

/// Errors of computed ends, over the first ones that are in both lists.
template <typename Ends, typename PreciseEnds>
ErrorSizes errors_of(const Ends& ends, const PreciseEnds& precise) {
  ErrorSizes result;
  const std::size_t count = std::min(ends.size(), precise.size());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < ends[k].size(); ++i) {
      const double error = static_cast<double>(std::fabs(ends[k][i] - precise[k][i].v));
      result.largest = error <= result.largest ? result.largest : error;  // NaN counts
      result.rms += error * error;
    }
  }
  result.rms = std::sqrt(result.rms / static_cast<double>(count));
  return result;
}

}  // namespace lober::bench
