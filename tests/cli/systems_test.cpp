// The list of systems, and what it says of one.
#include <cmath>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

using SystemsProgram = ProgramTest;

TEST_F(SystemsProgram, ListsThemAll) {
  const Outcome outcome = run({"systems", "--json", "list.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json list = Json::parse(read("list.json"))["systems"];
  const std::vector<SystemInfo> known = list_systems();
  ASSERT_EQ(list.size(), known.size());
  for (std::size_t k = 0; k < known.size(); ++k) {
    EXPECT_EQ(list[k]["name"], known[k].name);
    EXPECT_EQ(list[k]["parameters"].size(), known[k].parameters.size());
    EXPECT_NE(("\n" + outcome.out).find("\n" + known[k].name + " "), std::string::npos) << outcome.out;
    // The list describes a system as the commands take it.
    const Outcome one = run({"systems", known[k].name, "--json", "-"});
    ASSERT_EQ(one.status, 0) << one.err;
    const Json details = Json::parse(one.out)["systems"];
    EXPECT_EQ(details["name"], known[k].name);
    EXPECT_FALSE(details["commands"].empty()) << known[k].name;
  }
}

// Fixed points, and ranges that are those that commands accept.
TEST_F(SystemsProgram, KnowsFixedPointsAndRanges) {
  const Json standard = Json::parse(run({"systems", "standard", "--json", "-"}).out)["systems"];
  ASSERT_EQ(standard["fixed_points"].size(), 2U);
  EXPECT_EQ(standard["fixed_points"][0]["type"], "saddle");
  EXPECT_NEAR(standard["fixed_points"][0]["residue"].get<double>(), -0.3, 1e-12);
  EXPECT_EQ(standard["parameters"][0]["min"], nullptr);
  EXPECT_NE(run({"systems", "ovp"}).out.find("; positive"), std::string::npos);
  EXPECT_NE(run({"systems", "ovp"}).out.find("; in [-8, 8]; size of the perturbation"), std::string::npos);
  EXPECT_NE(run({"systems", "henon"}).out.find("; any number"), std::string::npos);
  for (const SystemInfo& info : list_systems()) {
    for (const Parameter& parameter : info.parameters) {
      const auto accepted = [&](double value) {
        try {
          static_cast<void>(make_system(info.name, {{parameter.name, value}}));
          return true;
        } catch (const UsageError&) {
          return false;
        }
      };
      if (std::isfinite(parameter.min)) {
        EXPECT_EQ(accepted(parameter.min), !parameter.min_excluded) << info.name << ' ' << parameter.name;
        EXPECT_FALSE(accepted(parameter.min - 1)) << info.name << ' ' << parameter.name;
      }
      if (std::isfinite(parameter.max)) {
        EXPECT_EQ(accepted(parameter.max), !parameter.max_excluded) << info.name << ' ' << parameter.name;
        EXPECT_FALSE(accepted(parameter.max + 1)) << info.name << ' ' << parameter.name;
      }
    }
  }
}

TEST_F(SystemsProgram, TakesParameters) {
  const Outcome outcome = run({"systems", "standard", "--param", "K=2.5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("2.5"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("(x, y) -> (-x + y, y) turns the map into its inverse"), std::string::npos) << outcome.out;
  EXPECT_EQ(run({"systems", "standard", "--param", "Q=1"}).status, 2);
  EXPECT_EQ(run({"systems", "--param", "K=1"}).status, 2);
  const Outcome unknown = run({"systems", "nosuch"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("duffing"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace lober::cli
