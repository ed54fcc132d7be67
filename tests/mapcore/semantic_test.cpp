#include "mapcore/semantic.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

#include "mapcore/map.hpp"

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

TEST(Semantic, CopiesShareTheText) {
  Semantic semantic("wall,brick");
  const Semantic copy = semantic;
  EXPECT_EQ(copy.view().data(), semantic.view().data());
  semantic = Semantic("fence");
  EXPECT_EQ(copy.view(), "wall,brick");
  semantic = copy;
  semantic = std::move(semantic);  // NOLINT: a value survives that
  EXPECT_EQ(semantic.view(), "wall,brick");
}

// Texts of more threads than one, counted at once: the last holder ends each of them.
TEST(Semantic, MayBeCopiedInAnyThread) {
  const Semantic shared("wall,brick");
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&shared] {
      for (int k = 0; k < 10'000; ++k) {
        const std::vector<Semantic> copies(3, shared);
        ASSERT_EQ(copies.back().view(), "wall,brick");
      }
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(shared.view(), "wall,brick");
}

// What makes a map of ten million segments fit.
TEST(Segment, IsSixNumbersLong) {
  if constexpr (sizeof(void*) == 8) {
    EXPECT_EQ(sizeof(Segment), 48U);
  }
}

}  // namespace
}  // namespace mapwright
