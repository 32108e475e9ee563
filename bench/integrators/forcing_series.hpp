// Taylor series of what a field depends on by time alone.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace lober::bench {

/// From the Fourier series of the periodic forcing, of which every derivative is known: coefficients of high order are
/// then as good as those of low order. Interpolation between times within a step would lose them to rounding.
template <typename Field>
class ForcingSeries {
  using Complex = std::complex<long double>;
  static constexpr int samples = 128;

 public:
  explicit ForcingSeries(const Field& field) : frequency_(2 * std::numbers::pi_v<long double> / field.period()) {
    std::vector<std::array<double, Field::forcings>> values(samples);
    for (int j = 0; j < samples; ++j)
      field.forcing(field.period() * j / samples, values[static_cast<std::size_t>(j)].data());
    for (std::size_t f = 0; f < Field::forcings; ++f) {
      // Harmonics of the size of rounding are nothing but rounding.
      constexpr long double smallest = 1e-16L;
      for (int m = 0; m < samples / 2; ++m) {
        Complex sum = 0;
        for (int j = 0; j < samples; ++j) {
          const long double turn = static_cast<long double>(j * m % samples) / samples;
          sum += static_cast<long double>(values[static_cast<std::size_t>(j)][f]) *
                 std::polar(1.0L, -2 * std::numbers::pi_v<long double> * turn);
        }
        sum *= (m == 0 ? 1.0L : 2.0L) / samples;
        harmonics_[f].push_back(std::abs(sum) > smallest ? sum : 0);
      }
      while (harmonics_[f].size() > 1 && harmonics_[f].back() == Complex(0)) harmonics_[f].pop_back();
    }
  }

  /// Around the time `from`, in (t - from) / h: coefficient k of number f at record[k * forcings + f].
  void coefficients(double from, double h, int order, double* record) const {
    for (std::size_t f = 0; f < Field::forcings; ++f) {
      for (int k = 0; k <= order; ++k) record[static_cast<std::size_t>(k) * Field::forcings + f] = 0;
      std::vector<long double> sums(static_cast<std::size_t>(order) + 1, 0);
      for (std::size_t m = 0; m < harmonics_[f].size(); ++m) {
        const long double speed = static_cast<long double>(m) * frequency_;
        Complex term = harmonics_[f][m] * std::polar(1.0L, speed * from);
        for (std::size_t k = 0; k < sums.size(); ++k) {
          sums[k] += term.real();
          term *= Complex(0, speed * h / static_cast<long double>(k + 1));
        }
      }
      for (std::size_t k = 0; k < sums.size(); ++k) record[k * Field::forcings + f] = static_cast<double>(sums[k]);
    }
  }

 private:
  long double frequency_;
  std::array<std::vector<Complex>, Field::forcings> harmonics_;
};

}  // namespace lober::bench
