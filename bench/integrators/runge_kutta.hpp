// A step of an explicit Runge-Kutta method with an estimate of its error, for any kind of number.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "bench/integrators/lane_block.hpp"
#include "bench/integrators/unrolled.hpp"
#include "kernels/wide.hpp"

namespace lober::bench {

template <typename Table>
struct RungeKutta {
  static constexpr bool chooses = false;
  static constexpr int error_power = Table::error_power;
  static std::string name() { return std::string(Table::name); }

  /// Numbers of a step that depend on time only.
  template <typename Field>
  static constexpr std::size_t record_size = Table::stages* Field::forcings;
  template <typename Field>
  static void tabulate(const Field& field, double from, double h, double* record) {
    for (std::size_t s = 0; s < Table::stages; ++s)
      field.forcing(from + Table::nodes[s] * h, record + s * Field::forcings);
  }

  template <typename V, typename Field>
  LOBER_INLINE static void step(const Field& field, LaneBlock<Field::dimension>& block, std::size_t lane) {
    constexpr int size = Field::dimension;
    const V h = load_number<V>(block.h + lane);
    V x[size], slopes[Table::stages][size];
    for (int i = 0; i < size; ++i) x[i] = load_number<V>(block.x[i] + lane);
    unrolled<Table::stages>([&](auto stage) __attribute__((always_inline)) {
      constexpr int s = decltype(stage)::value;
      V at[size], force[Field::forcings + 1];
      for (int i = 0; i < size; ++i) {
        at[i] = x[i];
        if constexpr (s > 0) at[i] += h * sum<Row::stage, s>(slopes, i);
      }
      gather_forcing<Field>(block.forcing + lane, s, force);
      field.velocity(at, slopes[s], force);
    });

    V worst(0.0), all(0.0), squares[2] = {V(0.0), V(0.0)};
    for (int i = 0; i < size; ++i) {
      const V end = x[i] + h * sum<Row::end, 0>(slopes, i);
      store_number(block.end[i] + lane, end);
      const V allowed = block.tolerance * (1.0 + magnitude(x[i]) + magnitude(h * slopes[0][i]));
      const V share = h * sum<Row::error, 0>(slopes, i) / allowed;
      if constexpr (Table::estimates == 2) {
        const V coarse = h * sum<Row::error, 1>(slopes, i) / allowed;
        squares[0] += share * share;
        squares[1] += coarse * coarse;
      } else {
        worst = greater_number(worst, magnitude(share));
        all += share;
      }
    }
    if constexpr (Table::estimates == 2) {
      // The estimate of order 5 times its ratio to that of order 3 (Hairer, Norsett & Wanner, II.10).
      const V both = squares[0] + 0.01 * squares[1];
      worst = squares[0] / (square_root(both * static_cast<double>(size)) + 1e-300);
    }
    store_number(block.error + lane, worst + 0.0 * all);
  }

 private:
  enum class Row { stage, end, error };

  template <Row kind, int row>
  static constexpr double coefficient(int s) {
    return kind == Row::stage ? Table::a[row][s]
           : kind == Row::end ? Table::b[s]
                              : Table::errors[kind == Row::error ? row : 0][s];
  }
  template <Row kind, int row>
  static constexpr int first_of() {
    int s = 0;
    while (s < Table::stages && coefficient<kind, row>(s) == 0) ++s;
    return s;
  }

  /// The sum of the slopes of coordinate i, times the numbers of a row of the table.
  template <Row kind, int row, typename V, int size>
  LOBER_INLINE static V sum(const V (&slopes)[Table::stages][size], int i) {
    V result(0.0);
    unrolled<Table::stages>([&](auto stage) __attribute__((always_inline)) {
      constexpr int s = decltype(stage)::value;
      constexpr double factor = coefficient<kind, row>(s);
      if constexpr (s == first_of<kind, row>()) {
        result = factor * slopes[s][i];
      } else if constexpr (factor != 0) {
        result += factor * slopes[s][i];
      }
    });
    return result;
  }
};

}  // namespace lober::bench
