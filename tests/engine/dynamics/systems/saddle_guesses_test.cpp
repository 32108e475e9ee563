// Whether the saddles that a built-in system names for its tangle are there, over the ranges of its parameters; where
// they are not, how to find others is said.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/dynamics/manifolds/saddle.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober {
namespace {

// Values of a parameter that a user may try.
std::vector<double> values_of(const Parameter& parameter) {
  std::vector<double> values;
  if (std::isfinite(parameter.min) && std::isfinite(parameter.max)) {
    for (int k = 0; k <= 2; ++k) values.push_back(parameter.min + 0.5 * k * (parameter.max - parameter.min));
  }
  for (const double factor : {0.5, 0.95, 1.05, 2.0}) {
    values.push_back(factor * parameter.value);
  }
  if (!(parameter.min >= 0)) values.insert(values.end(), {0, -parameter.value, -0.5, 0.5, -1, 1});
  std::erase_if(values, [&](double value) {
    return value < parameter.min || value > parameter.max || (parameter.min_excluded && value == parameter.min) ||
           (parameter.max_excluded && value == parameter.max);
  });
  return values;
}

// Whether there is a saddle near a guess; if not the message says how to find those that there are.
bool is_there(const System& system, Point guess, int steps) {
  try {
    (void)detail::saddle_near(*system.map, steps, guess);
    return true;
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("a search for fixed points"), std::string::npos)
        << system.info.name << ": " << error.what();
    return false;
  }
}

TEST(SaddleGuesses, FollowTheParameters) {
  std::size_t found = 0, missed = 0, without = 0;
  for (const SystemInfo& info : list_systems()) {
    for (const Parameter& parameter : info.parameters) {
      for (const double value : values_of(parameter)) {
        const System system = make_system(info.name, {{parameter.name, value}});
        if (!system.map) continue;
        if (!system.connection) {
          without += system.no_connection.empty() ? 0 : 1;
          continue;
        }
        for (const int steps : {1, -1}) {
          const bool there = is_there(system, steps > 0 ? system.connection->from : system.connection->to, steps);
          (there ? found : missed) += 1;
          // Next to its own parameters every system has its saddles.
          if (std::fabs(value - parameter.value) < 0.1 * std::fabs(parameter.value)) {
            EXPECT_TRUE(there) << info.name << " " << parameter.name << " = " << value;
          }
        }
      }
    }
  }
  EXPECT_GT(without, 0U);
  EXPECT_GT(found, 5 * missed) << missed;
}

// The saddle of the tangle of Sun and Jupiter becomes that of the Earth and the Moon, far from where it was, and of two
// equal masses.
TEST(SaddleGuesses, ReachTheEarthAndTheMoon) {
  const System system = make_system("pcr3bp", {{"mu", 0.01215}});
  ASSERT_TRUE(system.connection) << system.no_connection;
  const FixedPoint found = find_fixed_point(*system.map, system.connection->from);
  EXPECT_EQ(found.kind, FixedPointKind::saddle);
  EXPECT_NEAR(found.at.x, -2.16, 0.02);
  EXPECT_LT(std::fabs(found.at.y), 1e-9);
  EXPECT_TRUE(make_system("pcr3bp", {{"mu", 0.5}}).connection);
  const System too_far = make_system("pcr3bp", {{"energy", -1.7}});
  EXPECT_FALSE(too_far.connection);
  EXPECT_NE(too_far.no_connection.find("is lost near mu = 0.0009537, energy = -1.573"), std::string::npos)
      << too_far.no_connection;
}

// The saddles of the vortex pair run away from each other in strains below 0, and lie unevenly in other phases.
TEST(SaddleGuesses, ReachStrainsOfEitherSign) {
  const auto saddles = [](double strain, double phase) {
    const System system = make_system("ovp", {{"eps", strain}, {"phase", phase}});
    EXPECT_TRUE(system.connection) << strain;
    const Point u = detail::saddle_near(*system.map, 1, system.connection->from).at;
    const Point s = detail::saddle_near(*system.map, -1, system.connection->to).at;
    for (const double x : {u.x, s.x}) EXPECT_TRUE(x > system.window.min_x && x < system.window.max_x) << strain;
    return std::pair{u.x, s.x};
  };
  EXPECT_NEAR(saddles(-0.3, 0).first, 3.42962, 1e-5);
  EXPECT_NEAR(saddles(-1, 0).second, -28.0667, 1e-4);
  EXPECT_NEAR(saddles(1, 0).first, 0.73914, 1e-5);
  // A multiplier of 560 000: Newton's method needs a guess to six digits.
  EXPECT_NEAR(saddles(1.6, 0).first, 0.64694, 1e-5);
  EXPECT_NEAR(saddles(0.3, 0.25).first, 1.53818, 1e-5);
  EXPECT_NEAR(saddles(0.3, 0.25).second, -1.24160, 1e-5);
  const System lost = make_system("ovp", {{"eps", 2}});
  EXPECT_FALSE(lost.connection);
  EXPECT_NE(lost.no_connection.find("is lost near eps = 1.655"), std::string::npos) << lost.no_connection;
  EXPECT_NE(make_system("pcr3bp", {{"mu", 0}}).no_connection.find("of two bodies"), std::string::npos);
}

}  // namespace
}  // namespace lober
