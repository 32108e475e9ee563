// A step by the Taylor series of the trajectory, of any order.
//
// The series is in the fraction of the step, so that its sum is the change. Its last two terms are the error; where
// they are too large, a shorter step is read off the same series, so that no step is computed in vain (Jorba & Zou
// 2005). The series of the forcing comes from tables.
#pragma once

#include <cstddef>
#include <string>

#include "bench/integrators/forcing_series.hpp"
#include "bench/integrators/lane_block.hpp"
#include "bench/integrators/series.hpp"
#include "bench/integrators/unrolled.hpp"
#include "kernels/wide.hpp"

namespace lober::bench {

template <int order>
struct Taylor {
  static constexpr bool chooses = true;
  static constexpr int error_power = order - 1;
  static std::string name() { return "Taylor " + std::to_string(order); }

  template <typename Field>
  static constexpr std::size_t record_size = (order + 1) * Field::forcings;
  /// Number f of the forcing has its coefficients at f, f + forcings ...
  template <typename Field>
  static void tabulate(const Field& field, double from, double h, double* record) {
    if constexpr (Field::forcings > 0) {
      static const ForcingSeries<Field> series(field);  // each type of field is compared with one set of parameters
      series.coefficients(from, h, order, record);
    }
  }

  template <typename V, typename Field>
  LOBER_INLINE static void step(const Field& field, LaneBlock<Field::dimension>& block, std::size_t lane) {
    constexpr int size = Field::dimension;
    SeriesSheet<order, V> sheet;
    const V h = load_number<V>(block.h + lane);
    for (int i = 0; i < size; ++i) sheet.at[i][0] = load_number<V>(block.x[i] + lane);
    unrolled<order>([&](auto n) __attribute__((always_inline)) {
      next_order<decltype(n)::value>(field, sheet, block.forcing + lane, h);
    });

    V worst(0.0), all(0.0);
    for (int i = 0; i < size; ++i) {
      const V* const c = sheet.at[i];
      const V allowed = block.tolerance * (1.0 + magnitude(c[0]) + magnitude(c[1]));
      const V share = greater_number(magnitude(c[order]), magnitude(c[order - 1])) / allowed;
      worst = greater_number(worst, share);
      all += share;
    }
    store_number(block.error + lane, worst + 0.0 * all);
    for (std::size_t k = lane; k < lane + sizeof(V) / sizeof(double); ++k) choose_step(block, k);
    const V taken = load_number<V>(block.taken + lane);
    for (int i = 0; i < size; ++i) {
      const V* const c = sheet.at[i];
      V change = c[order] * taken;
      for (int k = order - 1; k > 0; --k) change = (change + c[k]) * taken;
      store_number(block.end[i] + lane, c[0] + change);
    }
  }

 private:
  /// Rows 0 ... size - 1 are the state, those after them the forcing, then come the operations in their order.
  template <int n, typename V, typename Field>
  LOBER_INLINE static void next_order(const Field& field, SeriesSheet<order, V>& sheet, const double* const* forcing,
                                      V h) {
    constexpr int size = Field::dimension, forcings = static_cast<int>(Field::forcings);
    using Number = Series<order, V, n>;
    typename Number::Replay replay{&sheet, size + forcings};
    Number x[size], slope[size], force[forcings + 1];
    for (int i = 0; i < size; ++i) x[i] = {&replay, i};
    for (int f = 0; f < forcings; ++f) {
      sheet.at[size + f][n] = gather_number<V>(forcing, static_cast<std::size_t>(n * forcings + f));
      force[f] = {&replay, size + f};
    }
    field.velocity(x, slope, force);
    const V factor = h * inverses.of[n + 1];
    for (int i = 0; i < size; ++i) sheet.at[i][n + 1] = factor * slope[i].last();
  }

  /// Chooses the step of one lane by its error.
  template <int size>
  LOBER_INLINE static void choose_step(LaneBlock<size>& block, std::size_t lane) {
    const double error = block.error[lane];
    block.taken[lane] = 1;
    if (!(error < 1e300)) return;  // the driver sees it
    int exponent = StepFactors::lowest;
    if (error > 0) {
      const auto bits = __builtin_bit_cast(unsigned long long, error);
      exponent = static_cast<int>(bits >> 52U) - 1022;  // error < 2^exponent
    }
    if (exponent < StepFactors::lowest) exponent = StepFactors::lowest;
    if (exponent > StepFactors::highest) return;
    const double factor = block.factors->of[exponent - StepFactors::lowest];
    block.taken[lane] = factor < block.limit[lane] ? factor : block.limit[lane];
    if (factor < 1) block.error[lane] = 0;  // of what is taken it is small enough
  }

  struct Inverses {
    double of[order + 2];
  };
  static constexpr Inverses inverses = [] {
    Inverses result{};
    for (int n = 1; n <= order + 1; ++n) result.of[n] = 1.0 / n;
    return result;
  }();
};

}  // namespace lober::bench
