#include "engine/dynamics/systems/forced_oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {
namespace {

using Complex = std::complex<double>;
constexpr std::size_t harmonics = 40;
constexpr std::size_t samples_a_period = 128;

// The harmonics 0 .. `harmonics` of a real periodic function.
std::vector<Complex> spectrum(const std::vector<double>& values) {
  std::vector<Complex> result(harmonics + 1);
  for (std::size_t k = 0; k <= harmonics; ++k) {
    for (std::size_t j = 0; j < samples_a_period; ++j) {
      const double turns = static_cast<double>(j * k % samples_a_period) / samples_a_period;
      result[k] += values[j] * std::polar(1.0 / samples_a_period, -2 * std::numbers::pi * turns);
    }
  }
  return result;
}

}  // namespace

// The force is even in time about 0, and turns round with x half a period later.
std::vector<Symmetry> ForcedOscillator::symmetries(double phase) const {
  if (delta != 0) return {};
  if (at_half_periods(phase)) return {reversor({1, 0, 0, -1})};
  if (at_quarter_periods(phase)) return {reversor({-1, 0, 0, 1})};
  return {};
}

Point ForcedOscillator::saddle_on_section(double phase, const std::function<double(double)>& rest) const {
  const Complex i{0, 1};
  // (L u)_k = g_k with L u = u'' + delta u' - u; no harmonic is resonant, so that |1 / L_k| <= 1.
  const auto divisor = [&](std::size_t k) {
    const double frequency = omega * static_cast<double>(k);
    return -frequency * frequency - 1.0 + i * (delta * frequency);
  };
  std::vector<Complex> u(harmonics + 1);
  const auto at = [&](double turns, bool derivative) {
    double sum = derivative ? 0 : u[0].real();
    for (std::size_t k = 1; k <= harmonics; ++k) {
      const double number = static_cast<double>(k);
      const Complex factor = derivative ? i * (omega * number) : Complex{1};
      sum += 2 * (factor * u[k] * std::polar(1.0, 2 * std::numbers::pi * number * turns)).real();
    }
    return sum;
  };
  u[1] = 0.5 * eps / divisor(1);
  const Point first_order{at(phase, false), at(phase, true)};
  double change = 1;
  for (int round = 0; round < 500 && change > 1e-15; ++round) {
    std::vector<double> values(samples_a_period);
    for (std::size_t j = 0; j < samples_a_period; ++j)
      values[j] = rest(at(static_cast<double>(j) / samples_a_period, false));
    std::vector<Complex> next = spectrum(values);
    next[1] += 0.5 * eps;
    const double before = change;
    change = 0;
    for (std::size_t k = 0; k <= harmonics; ++k) {
      next[k] /= divisor(k);
      change = std::max(change, std::abs(next[k] - u[k]));
    }
    if (!(change < 1) || (round > 20 && change > 0.95 * before && change > 1e-12)) return first_order;
    u = std::move(next);
  }
  return {at(phase, false), at(phase, true)};
}

}  // namespace lober::detail
