#include "engine/batch/operations/options.hpp"

#include <gtest/gtest.h>

#include "engine/batch/operations/operation.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

const std::vector<OptionSpec> specs{{"flag", false},
                                    {"count", std::int64_t{2}, {}, {}, 0, 10},
                                    {"size", 0.5, {}, {}, 0},
                                    {"kind", "auto", {}, {"auto", "tree"}}};

std::string message_of(std::vector<OptionSetting> settings) {
  try {
    (void)Options(specs, settings);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Options, WhatIsNotGivenHasItsFallback) {
  EXPECT_EQ(Options(specs, {}).to_string(), "flag=false count=2 size=0.5 kind=auto");
}

TEST(Options, SpellingDoesNotDependOnHowTheyWereGiven) {
  const std::vector<OptionSetting> one{{"size", std::int64_t{3}}, {"flag", true}};
  const std::vector<OptionSetting> other{{"flag", false}, {"flag", true}, {"count", std::int64_t{2}}, {"size", 3.0}};
  EXPECT_EQ(Options(specs, one).to_string(), Options(specs, other).to_string());
  EXPECT_EQ(Options(specs, one).real("size"), 3.0);
}

TEST(Options, BadOnesAreRefusedByName) {
  EXPECT_EQ(message_of({{"colour", true}}), "colour: there is no such option; there are flag, count, size, kind");
  EXPECT_EQ(message_of({{"flag", std::int64_t{1}}}), "flag: has to be true or false");
  EXPECT_EQ(message_of({{"count", 1.5}}), "count: has to be a whole number");
  EXPECT_EQ(message_of({{"count", std::int64_t{11}}}), "count: has to be at most 10");
  EXPECT_EQ(message_of({{"size", -1.0}}), "size: has to be at least 0");
  EXPECT_EQ(message_of({{"kind", std::string("grid")}}), "kind: \"grid\" cannot be read as one of auto, tree");
}

TEST(Operations, TableIsConsistent) {
  for (const Operation& operation : all_operations()) {
    EXPECT_EQ(find_operation(operation.name), &operation);
    EXPECT_NO_THROW((void)Options(operation.options, {}));
    EXPECT_GT(operation.cost(1000), 0);
  }
  EXPECT_EQ(find_operation("none"), nullptr);
}

}  // namespace
}  // namespace lober::detail
