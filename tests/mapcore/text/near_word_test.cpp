#include "mapcore/text/near_word.hpp"

#include <gtest/gtest.h>

namespace mapwright::text {
namespace {

TEST(EditDistance, CountsSlips) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("wall", "wall"), 0U);
  EXPECT_EQ(edit_distance("wal", "wall"), 1U);
  EXPECT_EQ(edit_distance("walll", "wall"), 1U);
  EXPECT_EQ(edit_distance("well", "wall"), 1U);
  EXPECT_EQ(edit_distance("awll", "wall"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
}

TEST(NearWord, IsTheNearestThatCanBeMeant) {
  const std::vector<std::string_view> words{"checks", "profile", "profiles"};
  EXPECT_EQ(near_word("cheks", words), "checks");
  EXPECT_EQ(near_word("CHECKS", words), "checks");
  EXPECT_EQ(near_word("profilees", words), "profiles");
  EXPECT_EQ(near_word("robot", words), std::nullopt);
  EXPECT_EQ(near_word("", words), std::nullopt);
  EXPECT_EQ(near_word(std::string(100'000, 'c'), words), std::nullopt);
}

}  // namespace
}  // namespace mapwright::text
