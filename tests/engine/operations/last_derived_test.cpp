#include "engine/operations/last_derived.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace lober::detail::table {
namespace {

operations::Options options_with(std::int64_t value) {
  const std::vector<operations::OptionSpec> specs{{"number", std::int64_t{0}, "a number"}};
  const std::vector<operations::OptionSetting> settings{{"number", value}};
  return {specs, settings};
}

class LastDerivedTest : public testing::Test {
 protected:
  std::int64_t of(const operations::Options& options, const void* owner) {
    return last_.of(options, owner, [this](const operations::Options& given) {
      ++made_;
      return given.whole("number");
    });
  }
  LastDerived<std::int64_t> last_;
  int made_ = 0;
};

TEST_F(LastDerivedTest, IsMadeOnceForTheSameOptionsAndCopiesOfThem) {
  const operations::Options options = options_with(7), copy = options;
  EXPECT_EQ(of(options, this), 7);
  EXPECT_EQ(of(options, this), 7);
  EXPECT_EQ(of(copy, this), 7);
  EXPECT_EQ(made_, 1);
}

TEST_F(LastDerivedTest, IsMadeAnewForOtherOptionsAndOwners) {
  const operations::Options first = options_with(1), second = options_with(2);
  EXPECT_EQ(of(first, this), 1);
  EXPECT_EQ(of(second, this), 2);
  EXPECT_EQ(of(first, this), 1);
  EXPECT_EQ(of(first, &made_), 1);
  EXPECT_EQ(made_, 4);
}

// Options that are gone could otherwise be mistaken for new ones in their place.
TEST_F(LastDerivedTest, OptionsThatCameAndWentAreNotMixedUp) {
  for (std::int64_t k = 0; k < 100; ++k) EXPECT_EQ(of(options_with(k), this), k);
  EXPECT_EQ(made_, 100);
}

TEST_F(LastDerivedTest, KeepsNothingWhereMakingThrows) {
  const operations::Options options = options_with(3);
  EXPECT_EQ(of(options, this), 3);
  const auto fail = [](const operations::Options&) -> std::int64_t { throw std::runtime_error("no"); };
  EXPECT_THROW((void)last_.of(options_with(4), this, fail), std::runtime_error);
  EXPECT_EQ(of(options, this), 3);
  EXPECT_EQ(made_, 2);
}

}  // namespace
}  // namespace lober::detail::table
