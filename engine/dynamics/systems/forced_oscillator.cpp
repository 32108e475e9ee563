#include "engine/dynamics/systems/forced_oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace lober {
namespace {

using Complex = std::complex<double>;
constexpr int harmonics = 40;
constexpr int samples = 128;

Complex turn(long parts, long whole) {
  return std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(parts % whole) / static_cast<double>(whole));
}

// The harmonics 0 .. `harmonics` of a real periodic function.
std::vector<Complex> spectrum(const std::vector<double>& values) {
  std::vector<Complex> result(harmonics + 1);
  for (int k = 0; k <= harmonics; ++k) {
    for (int j = 0; j < samples; ++j) result[k] += values[j] * turn(-static_cast<long>(j) * k, samples);
    result[k] /= samples;
  }
  return result;
}

}  // namespace

Point ForcedOscillator::saddle_on_section(double phase, const std::function<double(double)>& rest) const {
  const Complex i{0, 1};
  // (L u)_k = g_k with L u = u'' + delta u' - u; no harmonic is resonant, so that |1 / L_k| <= 1.
  const auto divisor = [&](int k) { return -k * k * omega * omega - 1.0 + i * (delta * omega * k); };
  std::vector<Complex> u(harmonics + 1);
  const auto at = [&](double turns, bool derivative) {
    double sum = derivative ? 0 : u[0].real();
    for (int k = 1; k <= harmonics; ++k) {
      const Complex factor = derivative ? i * (omega * k) : Complex{1};
      sum += 2 * (factor * u[k] * std::polar(1.0, 2 * std::numbers::pi * k * turns)).real();
    }
    return sum;
  };
  u[1] = 0.5 * eps / divisor(1);
  const Point first_order{at(phase, false), at(phase, true)};
  double change = 1;
  for (int round = 0; round < 500 && change > 1e-15; ++round) {
    std::vector<double> values(samples);
    for (int j = 0; j < samples; ++j) values[j] = rest(at(static_cast<double>(j) / samples, false));
    std::vector<Complex> next = spectrum(values);
    next[1] += 0.5 * eps;
    const double before = change;
    change = 0;
    for (int k = 0; k <= harmonics; ++k) {
      next[k] /= divisor(k);
      change = std::max(change, std::abs(next[k] - u[k]));
    }
    if (!(change < 1) || (round > 20 && change > 0.95 * before && change > 1e-12)) return first_order;
    u = std::move(next);
  }
  return {at(phase, false), at(phase, true)};
}

}  // namespace lober
