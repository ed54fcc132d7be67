#include "mapcore/semantic.hpp"

#include <gtest/gtest.h>

namespace mapwright {
namespace {

TEST(Semantic, SplitsTokensAndTrimsThem) {
  const Semantic semantic("column, A5 ,inner_of=3");
  EXPECT_EQ(semantic.tokens(), (std::vector<std::string_view>{"column", "A5", "inner_of=3"}));
  EXPECT_EQ(semantic.labels(), (std::vector<std::string_view>{"column", "A5"}));
  EXPECT_EQ(semantic.value("inner_of"), "3");
  EXPECT_FALSE(semantic.value("normal").has_value());
  EXPECT_TRUE(semantic.has_label("A5"));
  EXPECT_FALSE(semantic.has_label("a5"));
}

TEST(Semantic, SetsAValueInPlaceAndKeepsOtherBytes) {
  EXPECT_EQ(Semantic("a, level=1 ,b").with_value("level", "2").view(), "a, level=2 ,b");
  EXPECT_EQ(Semantic("a").with_value("level", "2").view(), "a,level=2");
  EXPECT_EQ(Semantic("").with_value("level", "2").view(), "level=2");
}

TEST(Semantic, ComparesByText) {
  EXPECT_EQ(Semantic("wall"), Semantic(std::string("wall")));
  EXPECT_FALSE(Semantic("wall") == Semantic("Wall"));
  EXPECT_EQ(Semantic(""), Semantic());
}

}  // namespace
}  // namespace mapwright
