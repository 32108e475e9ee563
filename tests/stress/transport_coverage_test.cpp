// Whether the error bars of lobes and fluxes hold what they promise, on systems with random parameters: every area by
// geometry against the area by action, every T(n) by lobes against that by boundaries.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/transport/transport.hpp"
#include "tests/environment.hpp"
#include "tests/stress/coverage.hpp"

namespace lober {
namespace {

struct SystemFamily {
  std::string system;
  std::vector<std::pair<std::string, std::pair<double, double>>> ranges;
};

const std::vector<SystemFamily> system_families{
    {"standard", {{"K", {0.25, 6}}}},
    {"henon", {{"k", {-0.9, 2}}}},
    {"ovp", {{"gamma", {0.3, 1.2}}, {"eps", {0.02, 0.2}}}},
    {"duffing", {{"eps", {0.005, 0.2}}, {"omega", {0.9, 3}}}},
};

// LOBER_COVERAGE_SYSTEMS: how many of each family.
TEST(TransportCoverage, OfLobesAndFluxes) {
  const std::uint64_t seed = from_environment("LOBER_SEED", 20261122);
  const std::uint64_t count = from_environment("LOBER_COVERAGE_SYSTEMS", 2);
  std::mt19937_64 random(seed);
  std::size_t compared = 0, outside = 0, refused = 0;
  double worst = 0;
  std::map<std::string, std::vector<double>> looseness;  // bars in units of the difference, by what is compared
  for (const SystemFamily& family : system_families) {
    for (std::uint64_t k = 0; k < count; ++k) {
      ParameterValues values;
      std::string text = family.system;
      for (const auto& [name, range] : family.ranges) {
        values.emplace_back(name, std::uniform_real_distribution<double>(range.first, range.second)(random));
        text += " " + name + "=" + std::to_string(values.back().second);
      }
      const System system = make_system(family.system, values);
      TransportOptions options;
      options.iterates = 3;
      options.max_work = 3e7;
      try {
        const Transport found = transport(system, options);
        for (const Comparison& one : found.agreement.comparisons) {
          ++compared;
          if (one.bar > 0) worst = std::max(worst, one.difference() / one.bar);
          if (one.difference() > 0)
            looseness[one.first_by + " and " + one.second_by].push_back(one.bar / one.difference());
          if (one.agrees()) continue;
          ++outside;
          std::cout << text << ": " << one.what << " " << one.first << " by " << one.first_by << ", " << one.second
                    << " by " << one.second_by << ", bar " << one.bar << "\n";
        }
      } catch (const DataError& error) {
        ++refused;
        std::cout << text << ": " << error.what() << "\n";
      }
    }
  }
  std::cout << "bars of transport (seed " << seed << "): " << outside << " of " << compared
            << " comparisons outside, the largest difference is " << worst << " bars; " << refused << " of "
            << count * system_families.size() << " systems refused\n";
  for (auto& [ways, ratios] : looseness) {
    std::sort(ratios.begin(), ratios.end());
    std::cout << "bars of " << ways << ", in differences: median " << stress::quantile(ratios, 0.5) << ", 90 % below "
              << stress::quantile(ratios, 0.9) << ", " << ratios.size() << " of them\n";
  }
  EXPECT_GE(compared, 8 * count);
  EXPECT_LE(1000 * outside, compared);
}

}  // namespace
}  // namespace lober
