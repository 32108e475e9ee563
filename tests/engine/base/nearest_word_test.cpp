#include "engine/base/nearest_word.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lober::detail {
namespace {

TEST(NearestWord, CountsEdits) {
  EXPECT_EQ(edit_distance("overlay", "overlay"), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("overlya", "overlay"), 1U);  // neighbours exchanged
  EXPECT_EQ(edit_distance("overly", "overlay"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestWord, IsTheOneWithTheFewestEdits) {
  const std::vector<std::string> commands{"overlay", "interior", "tangle", "transport", "fixed-points", "henon"};
  EXPECT_EQ(nearest_word("overley", commands), "overlay");
  EXPECT_EQ(nearest_word("henonn", commands), "henon");
  EXPECT_EQ(nearest_word("fixed_points", commands), "fixed-points");
  EXPECT_EQ(nearest_word("Tangle", commands), "tangle");
  EXPECT_EQ(nearest_word("frobnicate", commands), "");
  EXPECT_EQ(nearest_word("", commands), "");
  EXPECT_EQ(nearest_word(std::string(100000, 'x'), commands), "");
}

TEST(NearestWord, OfShortWordsOnlyTheCaseMayDiffer) {
  const std::vector<std::string> parameters{"K", "eps", "gamma"};
  EXPECT_EQ(nearest_word("k", parameters), "K");
  EXPECT_EQ(nearest_word("q", parameters), "");
  EXPECT_EQ(nearest_word("ep", parameters), "");
  EXPECT_EQ(nearest_word("esp", parameters), "eps");
  EXPECT_EQ(nearest_word("gama", parameters), "gamma");
}

TEST(NearestWord, BeginsWithTheWordWhereOnlyOneDoes) {
  const std::vector<std::string> commands{"transport", "tangle", "curve-transport", "curve-tangle"};
  EXPECT_EQ(nearest_word("trans", commands), "transport");
  EXPECT_EQ(nearest_word("tr", commands), "");
  EXPECT_EQ(nearest_word("curve", commands), "");  // of two
}

TEST(NearestWord, EndsAMessage) {
  const std::vector<std::string> rules{"nonzero", "evenodd"};
  EXPECT_EQ(did_you_mean("nonzer", rules), "; did you mean nonzero?");
  EXPECT_EQ(did_you_mean("tree", rules), "");
  EXPECT_EQ(joined(rules), "nonzero, evenodd");
}

}  // namespace
}  // namespace lober::detail
