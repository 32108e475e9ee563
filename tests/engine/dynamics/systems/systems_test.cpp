// Systems by name and from shared libraries.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/base/utf8.hpp"
#include "engine/dynamics/dynamics.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/periodic_orbit.hpp"
#include "tests/paths.hpp"
#include "tests/refusal.hpp"

namespace lober::detail {
namespace {

/// The message of make_system for a request that it refuses.
template <typename Refusal>
std::string system_refusal(const std::string& name, const ParameterValues& values = {}) {
  return test::refusal<Refusal>([&] { static_cast<void>(make_system(name, values)); });
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Systems, AreListedWithDefaultsThatWork) {
  EXPECT_EQ(list_systems().size(), 10U);
  for (const SystemInfo& info : list_systems()) {
    SCOPED_TRACE(info.name);
    EXPECT_FALSE(info.summary.empty());
    const System system = make_system(info.name);
    EXPECT_NE(system.map, nullptr);
    EXPECT_GT(system.window.width(), 0);
    ParameterValues all;
    for (const Parameter& parameter : info.parameters) {
      EXPECT_FALSE(parameter.meaning.empty());
      all.emplace_back(parameter.name, parameter.value);
    }
    const Point z{system.window.min_x + 0.4 * system.window.width(), 0.1};
    Point a = z, b = z;
    system.map->iterate({&a, 1}, 1);
    make_system(info.name, all).map->iterate({&b, 1}, 1);
    EXPECT_TRUE(a == b || (std::isnan(a.x) && std::isnan(b.x)));
  }
}

// The largest difference between f S and S f, or S f^-1, over points near the saddle of the system's manifolds.
double asymmetry(const System& system, const Symmetry& symmetry) {
  const Point centre = system.connection ? system.connection->from : Point{0, 0};
  const double size = system.connection ? 0.1 : 0.2 * system.window.width();
  double worst = 0;
  int finite = 0;
  for (int k = 0; k < 25; ++k) {
    const Point z = centre + Point{size * (0.13 + 0.2 * (k % 5 - 2)), size * (0.07 + 0.2 * (k / 5 - 2))};
    Point around = symmetry(z), image = z;
    system.map->iterate({&around, 1}, 1);
    system.map->iterate({&image, 1}, symmetry.reversor ? -1 : 1);
    image = symmetry(image);
    if (!std::isfinite(around.x) && !std::isfinite(image.x)) continue;
    ++finite;
    worst = std::max(worst, distance(around, image));
  }
  EXPECT_GT(finite, 12);
  return worst;
}

TEST(Systems, HaveTheSymmetriesThatTheyClaim) {
  std::size_t checked = 0;
  for (const SystemInfo& info : list_systems()) {
    const bool has_phase = info.parameters.back().name == "phase";
    for (const double phase : {0.0, 0.25, 0.5, 0.75}) {
      if (!has_phase && phase != 0) break;
      SCOPED_TRACE(info.name + " at phase " + std::to_string(phase));
      const System system = make_system(info.name, has_phase ? ParameterValues{{"phase", phase}} : ParameterValues{});
      EXPECT_TRUE(phase != 0 || !system.symmetries.empty());
      for (const Symmetry& symmetry : system.symmetries) {
        // The ABC flow stretches errors of integration by thousands.
        EXPECT_LT(asymmetry(system, symmetry), info.name == "abc" ? 1e-7 : 1e-9);
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 30U);
}

TEST(Systems, ClaimNoSymmetryThatTheyDoNotHave) {
  const System at_zero = make_system("duffing");
  ASSERT_EQ(at_zero.symmetries.size(), 1U);
  const System between = make_system("duffing", {{"phase", 0.1}});
  EXPECT_TRUE(between.symmetries.empty());
  EXPECT_GT(asymmetry(between, at_zero.symmetries[0]), 1e-3);
  const System damped = make_system("duffing", {{"delta", 0.1}});
  EXPECT_TRUE(damped.symmetries.empty());
  EXPECT_GT(asymmetry(damped, at_zero.symmetries[0]), 1e-3);
}

TEST(Systems, KeepTheValuesChosen) {
  const System system = make_system("ovp", {{"eps", 0.2}, {"gamma", 0.7}});
  EXPECT_EQ(system.info.parameters[0].value, 0.7);
  EXPECT_EQ(system.info.parameters[1].value, 0.2);
  EXPECT_EQ(system.info.parameters[2].value, 0);
}

TEST(Systems, UnknownNamesAreRefusedWithTheAlternatives) {
  EXPECT_TRUE(mentions(system_refusal<UsageError>("lorenz"),
                       "no system is called 'lorenz'; there are: abc, capsize, double-gyre"));
  EXPECT_TRUE(mentions(system_refusal<UsageError>("ovp", {{"epsilon", 1}}),
                       "has no parameter 'epsilon'; it has: gamma, eps, phase"));
  EXPECT_TRUE(mentions(system_refusal<UsageError>("ovp", {{"eps", 1}, {"eps", 1}}), "given twice"));
  EXPECT_TRUE(mentions(system_refusal<UsageError>("ovp", {{"gamma", -1}}), "gamma must be positive"));
  EXPECT_TRUE(mentions(system_refusal<UsageError>("henon", {{"k", std::nan("")}}), "k is not finite"));
  EXPECT_THROW(static_cast<void>(make_system("ovp", {}, {.tolerance = 0})), UsageError);
}

TEST(Systems, FromSharedLibraries) {
  const System quadratic = make_system(LOBER_EXAMPLES "/quadratic_map.so", {{"angle", 0.5}});
  EXPECT_EQ(quadratic.info.name, "quadratic");
  Point z{0.3, 0.2};
  quadratic.map->iterate({&z, 1}, 1);
  EXPECT_DOUBLE_EQ(z.x, 0.3 * std::cos(0.5) - (0.2 - 0.09) * std::sin(0.5));
  EXPECT_DOUBLE_EQ(z.y, 0.3 * std::sin(0.5) + (0.2 - 0.09) * std::cos(0.5));
  EXPECT_TRUE(mentions(system_refusal<UsageError>(LOBER_EXAMPLES "/quadratic_map.so", {{"k", 1}}), "it has: angle"));

  const System flow = make_system(LOBER_EXAMPLES "/henon_heiles.so");
  ASSERT_NE(flow.flow, nullptr);
  EXPECT_EQ(flow.flow->dimension(), 4);
  // The eight families of short periodic orbits (Henon & Heiles 1964), one of which runs within x = 0: four centres and
  // three saddles are left.
  int saddles = 0, centres = 0;
  for (const FixedPoint& point : find_fixed_points(*flow.map, flow.window, {.grid = 20})) {
    saddles += point.kind == FixedPointKind::saddle ? 1 : 0;
    centres += point.kind == FixedPointKind::centre ? 1 : 0;
  }
  EXPECT_EQ(saddles, 3);
  EXPECT_EQ(centres, 4);
}

TEST(Systems, LibrariesDescribeTheirRegions) {
  const System second = make_system(LOBER_TEST_LIBRARIES "/with_connection.so", {{"k", 0.5}});
  ASSERT_TRUE(second.connection);
  EXPECT_DOUBLE_EQ(second.connection->from.x, 1 + std::sqrt(1.5));
  ASSERT_TRUE(second.connection->bip);
  EXPECT_EQ(second.connection->bip->y, 0.925);
  EXPECT_TRUE(second.further.empty());
  const System first = make_system(LOBER_TEST_LIBRARIES "/first_version.so");
  EXPECT_FALSE(first.connection);
  EXPECT_FALSE(first.further_needed);
}

TEST(Systems, LibrariesThatCannotBeUsedAreRefusedWithTheReason) {
  EXPECT_TRUE(mentions(system_refusal<DataError>("./absent.so"), "cannot load the system: ./absent.so"));
  EXPECT_TRUE(mentions(system_refusal<DataError>("absent.so"), "./absent.so"));
  const std::string folder = LOBER_TEST_LIBRARIES "/";
  EXPECT_TRUE(
      mentions(system_refusal<DataError>(folder + "no_description.so"), "exports no function lober_system_describe"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(folder + "other_version.so"), "built for another version"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(folder + "no_backward.so"), "the map has no backward"));
}

TEST(Systems, DescriptionsThatMakeNoSenseAreRefused) {
  const auto slip = [](int number) {
    return std::string(LOBER_TEST_LIBRARIES "/bad_description_") + std::to_string(number) + ".so";
  };
  EXPECT_TRUE(make_system(slip(0)).connection);
  const auto expect = [&](int number, const char* words) {
    const std::string message = system_refusal<DataError>(slip(number));
    EXPECT_TRUE(mentions(message, words)) << message;
  };
  expect(1, "connection_count is more than LOBER_MAX_CONNECTIONS");
  expect(2, "the window has a number that is not finite");
  expect(3, "the lattice has a number that is not finite");
  expect(4, "the lattice has a number that is not finite");
  expect(5, "the name or the summary is not UTF-8");
  expect(6, "a parameter's name or meaning is not UTF-8");
  expect(7, "connection 0 has a number that is not finite");
  EXPECT_TRUE(mentions(system_refusal<DataError>(slip(0) + std::string("\0.so", 4)), "zero byte"));
}

TEST(Systems, TextsAreUtf8) {
  for (const char* const good : {"", "plain", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_TRUE(is_utf8(good)) << good;
  }
  for (const char* const bad : {"\xff", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                                "\xe2\x82", "\x80", "a\xc3z", "\xf0\x80\x80\x80"}) {
    EXPECT_FALSE(is_utf8(bad)) << bad;
  }
}

// Functions that do not belong together are found before they give wrong results.
TEST(Systems, LibrariesAreChecked) {
  const auto slip = [](const char* kind, int number) {
    return std::string(LOBER_TEST_LIBRARIES "/wrong_") + kind + "_" + std::to_string(number) + ".so";
  };
  EXPECT_NE(make_system(slip("map", 0)).map, nullptr);
  EXPECT_NE(make_system(slip("flow", 0)).map, nullptr);
  const auto expect = [&](const char* kind, int number, std::initializer_list<const char*> words) {
    const std::string message = system_refusal<DataError>(slip(kind, number));
    for (const char* word : words) EXPECT_TRUE(mentions(message, word)) << message;
  };
  expect("map", 1, {"the derivative dx'/dy is wrong at (", "it is 1, but finite differences of forward give -"});
  expect("map", 2, {"backward is not the inverse of forward"});
  expect("map", 3, {"the action L(x, x') is wrong at (", "dL/dx is ", "-y is "});
  expect("map", 4, {"the map does not repeat after the shift (3, 0) of its lattice"});
  expect("map", 5, {"derivative fails, or gives no number, at all points of the window that have images"});
  expect("map", 6, {"derivative fails, or gives no number"});
  expect("flow", 1, {"the Jacobian d(velocity 1)/d(x 0) is wrong at (", "it is 2, but finite differences of velocity"});
  expect("flow", 2, {"the Hamiltonian, or the velocity 1, is wrong at (", "t = "});
  expect("flow", 3, {"velocity_batch, component 1, is wrong at ("});
  expect("flow", 4, {"the velocity does not repeat after a period of 6: component 1 is "});
  expect("flow", 5, {"the velocity does not repeat after the shift (1, 0) of its lattice"});
  expect("flow", 6, {"jacobian fails, or gives no number"});
  expect("flow", 7, {"hamiltonian, or a factor of its pairs, fails, or gives no number"});
}

// A unit of length is the user's: the same system in millionths and in millions of it is loaded, and has the same
// orbits.
TEST(Systems, LibrariesInOtherUnits) {
  const auto flow = [](int number) {
    return make_system(LOBER_TEST_LIBRARIES "/wrong_flow_" + std::to_string(number) + ".so");
  };
  const System one = flow(0);
  for (const auto& [number, unit] : {std::pair{8, 1e-6}, std::pair{9, 1e6}}) {
    const System other = flow(number);
    for (const Point z : {Point{0.3, 0.2}, Point{-1.8, 1.5}, Point{3.1, 0.1}}) {
      Point a = z, b{unit * z.x, unit * z.y};
      one.map->iterate({&a, 1}, 1);
      other.map->iterate({&b, 1}, 1);
      EXPECT_LT(distance(a, {b.x / unit, b.y / unit}), 1e-5) << unit;
    }
  }
  const System large = flow(9), small_units = flow(8);
  const std::vector<FixedPoint> found = find_fixed_points(*large.map, large.window);
  EXPECT_EQ(found.size(), find_fixed_points(*one.map, one.window).size());
  EXPECT_EQ(found.size(), find_fixed_points(*small_units.map, small_units.window).size());
  std::size_t saddles = 0;
  for (const FixedPoint& point : found) {
    if (point.kind != FixedPointKind::saddle) continue;
    EXPECT_NO_THROW((void)local_manifold(*large.map, point.at, ManifoldSide::unstable));
    const Point small{1e-12 * point.at.x, 1e-12 * point.at.y};
    EXPECT_NO_THROW((void)local_manifold(*small_units.map, small, ManifoldSide::unstable));
    ++saddles;
  }
  EXPECT_EQ(saddles, 2U);
}

// Sections of angles, ranges and the role of a parameter come from libraries as from built-in systems.
TEST(Systems, LibrariesDeclareAnglesAndRanges) {
  const std::string path = LOBER_TEST_LIBRARIES "/angles_";
  const System own = make_system(path + "0.so"), built_in = make_system("abc");
  ASSERT_TRUE(own.section);
  EXPECT_EQ(own.section->period, built_in.section->period);
  EXPECT_EQ(own.second_lattice, built_in.second_lattice);
  for (const Point z : {Point{0.3, 0.2}, Point{-1, 1.5}, Point{0.7, 3}}) {
    Point a = z, b = z;
    own.map->iterate({&a, 1}, 1);
    built_in.map->iterate({&b, 1}, 1);
    EXPECT_LT(distance(a, b), 1e-9);
  }
  ASSERT_NE(own.info.perturbation(), nullptr);
  EXPECT_EQ(own.info.perturbation()->name, "C");
  EXPECT_EQ(own.info.parameters[0].range(), "");
  const auto refused = [&](const char* name, double value) {
    return system_refusal<UsageError>(path + "0.so", {{name, value}});
  };
  EXPECT_TRUE(mentions(refused("B", 0), "system abc-c: parameter B must be positive, not 0"));
  EXPECT_TRUE(mentions(refused("C", 2), "parameter C must be in [0, 2), not 2"));
  EXPECT_NO_THROW(static_cast<void>(make_system(path + "0.so", {{"C", 0}})));
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "1.so"), "the range of parameter B is empty"));
  EXPECT_TRUE(
      mentions(system_refusal<DataError>(path + "2.so"), "the default of parameter C, 1, is outside of its range"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "3.so"),
                       "the perturbation is called D, but no parameter has this name"));
}

// Saddles of a library are those of the built-in system, and Hill's region and the bottlenecks with them.
TEST(Systems, LibrariesDeclareSaddles) {
  const std::string path = LOBER_TEST_LIBRARIES "/three_body_";
  const System own = make_system(path + "0.so"), built_in = make_system("pcr3bp");
  ASSERT_EQ(own.saddles.size(), built_in.saddles.size());
  for (std::size_t k = 0; k < own.saddles.size(); ++k) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(own.saddles[k][i], built_in.saddles[k][i], 1e-12);
    const SaddlePoint mine = saddle_point(*own.flow, own.saddles[k]);
    const SaddlePoint theirs = saddle_point(*built_in.flow, built_in.saddles[k]);
    EXPECT_NEAR(mine.energy, theirs.energy, 1e-13);
    EXPECT_NEAR(mine.at[0], theirs.at[0], 1e-12);
  }
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "1.so"), "saddle 0 has a number that is not finite"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "2.so"), "saddle 0 is not given for these parameters"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "3.so"), "saddle_count is more than LOBER_MAX_SADDLES, 64"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "4.so"), "saddle is null"));
  EXPECT_TRUE(mentions(system_refusal<DataError>(path + "5.so"), "saddles are those of an autonomous flow of four"));
}

TEST(Systems, UnitsArePowersOfTen) {
  for (int power = -299; power < 300; ++power) {
    const double unit = std::stod("1e" + std::to_string(power));
    EXPECT_EQ(unit_within(unit), unit);
    EXPECT_EQ(unit_within(9.99 * unit), unit);
    EXPECT_EQ(unit_within(std::nextafter(unit, 0)), std::stod("1e" + std::to_string(power - 1))) << power;
  }
  for (const double unknown : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(unit_within(unknown), 1) << unknown;
  }
}

TEST(Systems, RangesInWords) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto words = [](double min, double max, bool min_excluded, bool max_excluded) {
    return Parameter{"", 0, "", min, max, min_excluded, max_excluded}.range();
  };
  EXPECT_EQ(words(-infinity, infinity, false, false), "");
  EXPECT_EQ(words(0, infinity, true, false), "positive");
  EXPECT_EQ(words(0, infinity, false, false), "at least 0");
  EXPECT_EQ(words(2, infinity, true, false), "above 2");
  EXPECT_EQ(words(-infinity, 3, false, true), "below 3");
  EXPECT_EQ(words(-infinity, 3, false, false), "at most 3");
  EXPECT_EQ(words(0, 0.5, true, false), "in (0, 0.5]");
  for (const char* name : {"ovp", "ovp1", "duffing", "pendulum", "double-gyre"}) {
    ASSERT_NE(make_system(name).info.perturbation(), nullptr) << name;
    EXPECT_EQ(make_system(name).info.perturbation()->name, "eps");
  }
  EXPECT_EQ(make_system("henon").info.perturbation(), nullptr);
}

}  // namespace
}  // namespace lober::detail
