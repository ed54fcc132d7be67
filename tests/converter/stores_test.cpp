// Compact stores: lists, arenas, and chains against the obstacles they stand for.
#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <limits>
#include <memory>
#include <sstream>

#include "converter/pipeline/converted_map.hpp"
#include "converter/store/arena.hpp"
#include "converter/store/long_list.hpp"
#include "converter/store/small_list.hpp"
#include "mapcore/random.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright::converter {
namespace {

TEST(OneOrMore, HoldsAnyNumbers) {
  constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  for (const std::vector<std::int64_t>& numbers : {std::vector<std::int64_t>{},
                                                   {0},
                                                   {-1},
                                                   {kLeast},
                                                   {kMost},
                                                   {kMost / 2},
                                                   {kLeast / 2},
                                                   {7, 3},
                                                   {kLeast, 5},
                                                   {5, kLeast, -1, 5},
                                                   {0, 0, kMost}}) {
    OneOrMore list;
    for (const auto number : numbers) list.push_back(number);
    EXPECT_EQ(list.size(), numbers.size());
    EXPECT_EQ(list.empty(), numbers.empty());
    const auto told = [&] {
      std::vector<std::int64_t> all;
      for (const auto number : list) all.push_back(number);
      return all;
    };
    EXPECT_EQ(told(), numbers);
    const OneOrMore moved = std::exchange(list, {});
    EXPECT_TRUE(list.empty());
    EXPECT_EQ(moved.size(), numbers.size());
  }
}

TEST(OneOrMore, Sorts) {
  OneOrMore list;
  for (const int number : {3, -1, 2}) list.push_back(number);
  list.sort();
  EXPECT_EQ(list[0], -1);
  EXPECT_EQ(list[1], 2);
  EXPECT_EQ(list[2], 3);
}

TEST(NoneOrMore, ForgetsOnRequest) {
  NoneOrMore<std::string> list;
  EXPECT_EQ(list.begin(), list.end());
  list.push_back("a");
  list.push_back("b");
  EXPECT_EQ(list.size(), 2U);
  EXPECT_EQ(list.front(), "a");
  list.clear();
  EXPECT_TRUE(list.empty());
}

template <class List>
void expect_to_keep(int count) {
  List list;
  for (int i = 0; i < count; ++i) list.push_back(std::make_unique<int>(i));
  const auto* first = &list[0];
  List moved = std::move(list);
  EXPECT_EQ(&moved[0], first) << "what it holds stays where it is";
  int expected = 0;
  for (const auto& number : moved) EXPECT_EQ(*number, expected++);
  EXPECT_EQ(expected, count);
}

TEST(LongList, KeepsAllOfIt) {
  expect_to_keep<LongList<std::unique_ptr<int>>>(5000);
}

// Five mebibytes of them.
TEST(LongList, KeepsAllOfItInLastingBlocks) {
  expect_to_keep<LongList<std::unique_ptr<int>, kLastingBlock>>(5 << 17);
}

// What lasts lies beside the heap, so that the memory of what goes becomes one piece again, but for
// where the list's own list of blocks grew: a quarter can be had without the heap growing. (The
// settings are those with which it grows when it must.)
TEST(LongList, LeavesTheHeapInOnePieceWhereItLasts) {
  ::mallopt(M_MMAP_MAX, 0);
  ::mallopt(M_TRIM_THRESHOLD, INT_MAX);
  ::mallopt(M_TOP_PAD, 0);
  using Item = std::array<char, 32>;
  constexpr std::size_t kItems = std::size_t{1} << 19U;
  LongList<Item, kLastingBlock> lasting;
  {
    LongList<Item> passing;
    for (std::size_t i = 0; i < kItems; ++i) {
      lasting.push_back({});
      passing.push_back({});
    }
  }
  const void* const end = ::sbrk(0);
  ::operator delete(::operator new(kItems * sizeof(Item) / 4));
  EXPECT_EQ(::sbrk(0), end);
}

TEST(Arena, HandsOutRoomThatNobodyElseHas) {
  Arena<int> arena;
  Random random(4);
  std::vector<std::pair<int*, std::size_t>> pieces;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t count = random.below(50) + (i % 500 == 0 ? 1'000'000 : 0);
    int* const room = arena.take(count + 3);
    arena.give_back(3);
    std::fill(room, room + count, i);
    pieces.emplace_back(room, count);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto [room, count] = pieces[i];
    ASSERT_TRUE(std::all_of(room, room + count, [&](int n) { return n == static_cast<int>(i); }));
  }
}

// The text of a map of chains is the text of the map of segments.
TEST(ConvertedMap, WritesWhatItsObstaclesAre) {
  Random random(9);
  PlainObstacles plain;
  const text::DecimalFormat millimetres(0.001);
  int on_grid = 0;
  const std::string texts[] = {"building", "wall,name=Plaça", ""};
  for (int i = 0; i < 2000; ++i) {
    PlainObstacle chain;
    std::vector<Point> points(i % 100 == 0 ? 60 + random.below(200) : 2 + random.below(6));
    for (Point& p : points) {
      const double reach = i % 7 == 0 ? 1e14 : 3000.0;
      p = {random.uniform(-reach, reach), random.uniform(-reach, reach)};
      if (i % 3 > 0) p = {millimetres.rounded(p.x), millimetres.rounded(p.y)};
    }
    plain.set_points(chain, points);
    on_grid += chain.on_grid ? 1 : 0;
    std::vector<Point> room;
    ASSERT_TRUE(std::ranges::equal(plain.chain(chain, room), points));
    chain.joined = chain.count > 2 && random.below(2) == 0;
    chain.is_inner = i > 0 && chain.joined && random.below(4) == 0;
    chain.shape_type = chain.joined ? ShapeType::kClosedPolygon : ShapeType::kOpenPolygon;
    chain.height_m = random.uniform(0.0, 20.0);
    chain.id = i + 1;
    plain.add(chain, FeatureKind::kSolid, 0, texts[random.below(3)],
              random.below(2) == 0 ? InOut::kIndoor : InOut::kOutdoor, texts[random.below(3)]);
  }
  const std::size_t count = plain.all().size();
  EXPECT_GT(on_grid, 500);
  EXPECT_LT(on_grid, 1500);
  ConvertedMap map(std::move(plain), {}, {{true, 0, count}});
  map.border = {-1, 1, 1, -1};
  const Map whole = map.whole();
  EXPECT_EQ(whole.obstacles.size(), count);
  EXPECT_EQ(map.segment_count(), segment_count(whole));
  EXPECT_EQ(map.extent().min_y, extent(whole).min_y);
  EXPECT_EQ(map.extent().max_x, extent(whole).max_x);
  for (const double resolution : {0.001, 0.01, 1e-6}) {
    std::ostringstream text;
    map.write(text, {resolution});
    EXPECT_TRUE(text.str() == format_map(whole, {resolution})) << resolution;
  }
}

}  // namespace
}  // namespace mapwright::converter
