// Transport of random maps that preserve area exactly: products of shears, each with its inverse. Species keep their
// areas, lobes, boundaries and particles agree, and the inverse map, whose manifolds are those of the map exchanged,
// has the same fluxes. LOBER_RANDOM_TRANSPORT sets how many maps, LOBER_SEED where their numbers begin.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "engine/dynamics/maps/formula_map.hpp"
#include "lober/base/error.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail {
namespace {

std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

// (x, y) -> (x^2 - k - y, x), a shear after a turn by a right angle, and then two shears with sines.
struct Shears {
  double k, a, b, phase_a, phase_b, wave_a, wave_b;

  Point forward(Point z) const {
    z = {z.x * z.x - k - z.y, z.x};
    z.y += a * std::sin(wave_a * z.x + phase_a);
    z.x += b * std::sin(wave_b * z.y + phase_b);
    return z;
  }
  Point backward(Point z) const {
    z.x -= b * std::sin(wave_b * z.y + phase_b);
    z.y -= a * std::sin(wave_a * z.x + phase_a);
    return {z.y, z.y * z.y - k - z.x};
  }
  Matrix2 derivative(Point z) const {
    const Matrix2 turn{2 * z.x, -1, 1, 0};
    z = {z.x * z.x - k - z.y, z.x};
    const Matrix2 first{1, 0, a * wave_a * std::cos(wave_a * z.x + phase_a), 1};
    z.y += a * std::sin(wave_a * z.x + phase_a);
    const Matrix2 second{1, b * wave_b * std::cos(wave_b * z.y + phase_b), 0, 1};
    return second * (first * turn);
  }
};

// The inverse map.
struct Reversed {
  Shears map;
  Point forward(Point z) const { return map.backward(z); }
  Point backward(Point z) const { return map.forward(z); }
  Matrix2 derivative(Point z) const {
    const Matrix2 m = map.derivative(map.backward(z));
    return {m.yy, -m.xy, -m.yx, m.xx};
  }
};

Shears random_shears(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  return {between(0.0, 0.8), between(-0.08, 0.08), between(-0.08, 0.08), between(0, 6.28),
          between(0, 6.28),  between(0.5, 2),      between(0.5, 2)};
}

class RandomTransport : public testing::Test {
 protected:
  static void expect_agreement(const Transport& found) {
    for (const Comparison& pair : found.agreement.disagreements()) {
      ADD_FAILURE() << pair.what << ": " << pair.first << " by " << pair.first_by << ", " << pair.second << " by "
                    << pair.second_by << ", bars " << pair.bar;
    }
  }
};

TEST_F(RandomTransport, ThreeRoutesAgreeAndTimeReverses) {
  const std::uint64_t maps = setting("LOBER_RANDOM_TRANSPORT", 3), first = setting("LOBER_SEED", 1);
  constexpr int iterates = 5;
  std::uint64_t done = 0, without = 0;
  for (std::uint64_t k = 0; k < maps; ++k) {
    SCOPED_TRACE("map " + std::to_string(first + k));
    const Shears shears = random_shears(first + k);
    const FormulaMap<Shears> map(shears);
    const FormulaMap<Reversed> reversed(Reversed{shears});
    const double guess = 1 + std::sqrt(1 + shears.k);
    const Connection connection{{guess, guess}, {-1, -1}, {guess, guess}, {-1, -1}};
    TransportOptions options;
    options.iterates = iterates;
    options.tolerance = 1e-4;
    options.particles = 10'000;
    options.seed = first + k;
    Transport found;
    try {
      found = transport(map, connection, options);
    } catch (const DataError& error) {  // tangencies, or a bip whose turnstile is not of two lobes of either kind
      ++without;
      std::printf("map %llu has no transport: %s\n", static_cast<unsigned long long>(first + k), error.what());
      continue;
    }
    ++done;
    expect_agreement(found);
    options.bip_near = found.manifolds().orbits.back().at;
    options.particles = 0;
    const Transport back = transport(reversed, connection, options);
    expect_agreement(back);
    ASSERT_EQ(back.steps.size(), found.steps.size());
    const double area = found.regions[0].area.value;
    for (std::size_t n = 0; n < iterates; ++n) {
      const TransportStep &step = found.steps[n], &other = back.steps[n];
      const Measured out = step.total(0, 1), in = other.total(1, 0);
      EXPECT_LE(std::fabs(out.value - in.value), out.error + in.error);
      EXPECT_LE(std::fabs(step.total(0, 0).value + out.value - area),
                step.total(0, 0).error + out.error + found.regions[0].area.error);
      EXPECT_GT(out.value, 0);
      EXPECT_LT(out.error, 1e-3);
    }
  }
  EXPECT_GE(done, without) << "most maps have a tangle";
}

}  // namespace
}  // namespace lober::detail
