// Looking at a text obstacle by obstacle shows what reading it as a whole gives, or says that it
// cannot tell.
#include "mapcore/text/obstacle_stream.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "mapcore/random.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/mapcore/text/keeper.hpp"
#include "tests/support/random_map.hpp"

namespace mapwright {
namespace {

// The map that was shown; nothing where the text is not plain.
std::optional<Map> shown(const MapText& text) {
  Map map;
  const auto border = visit_obstacles(text, [&](const ObstacleView& view) {
    map.obstacles.push_back({view.id,
                             view.shape_type,
                             std::string(view.semantic),
                             {view.segments.begin(), view.segments.end()}});
    return true;
  });
  if (!border) return std::nullopt;
  map.border = *border;
  return map;
}

const std::string kBorder = "border;0;9;9;0;#\n";
const std::string kWall = "obstacle;7;2;2;wall;#\n1;2;3.5;4;5;1;;#\n3.5;4;6;-7.25;5;1;;#\n";

TEST(ObstacleStream, ShowsTheMapOfAPlainText) {
  const auto map = shown(kBorder + kWall + "obstacle;8;1;0;;#\n \n");
  ASSERT_TRUE(map);
  ASSERT_EQ(map->obstacles.size(), 2U);
  EXPECT_EQ(map->border, (Border{0.0, 9.0, 9.0, 0.0}));
  EXPECT_EQ(map->obstacles[0].id, 7);
  EXPECT_EQ(map->obstacles[0].shape_type, ShapeType::kOpenPolygon);
  EXPECT_EQ(map->obstacles[0].semantic.view(), "wall");
  const Segment last{{3.5, 4.0}, {6.0, -7.25}, 5.0, InOut::kOutdoor, ""};
  EXPECT_EQ(map->obstacles[0].segments.at(1), last);
  EXPECT_TRUE(map->obstacles[1].segments.empty());
}

TEST(ObstacleStream, TellsWhereEachObstacleStands) {
  const std::string text = kBorder + kWall + kWall;
  std::vector<std::size_t> offsets;
  visit_obstacles(text, [&](const ObstacleView& view) {
    offsets.push_back(view.offset);
    return true;
  });
  EXPECT_EQ(offsets, (std::vector<std::size_t>{kBorder.size(), kBorder.size() + kWall.size()}));
}

TEST(ObstacleStream, LeavesToTheReaderWhatIsNotPlain) {
  EXPECT_TRUE(shown(kBorder + kWall));
  EXPECT_TRUE(shown(kBorder));  // a map without obstacles
  const std::vector<std::string> texts{
      "",
      " \n",
      kWall,                                                    // no border
      kBorder + kBorder + kWall,                                //
      kBorder + kWall + kBorder,                                //
      kBorder + "1;2;3;4;5;1;;#\n" + kWall,                     // a segment of no obstacle
      kBorder + "obstacle;7;2;3;wall;#1;2;3;4;5;1;;#",          // fewer segments than declared
      kBorder + "obstacle;7;2;0;wall;#1;2;3;4;5;1;;#",          // more
      kBorder + "obstacle;7;9;1;wall;#1;2;3;4;5;1;;#",          // no such shape
      kBorder + "obstacle;7;2;1;wall;#1;2;3;4,5;5;1;;#",        // a decimal comma
      kBorder + "obstacle;7;2;1;wall;#1;2;3;inf;5;1;;#",        // no end
      kBorder + "obstacle;7;2;1;wall;#1;2;3;4;5;2;;#",          // no such inOut
      kBorder + "obstacle;7;2;1;wall\x01;#1;2;3;4;5;1;;#",      // a control character
      kBorder + "obstacle;7;2;1;wall\xE0\x80;#1;2;3;4;5;1;;#",  // no UTF-8
      kBorder + "obstacle;7;2;1;wall;#1;2;3;4;5;1;\xFF;#",      //
      kBorder + "obstacle;7;2;1;wall;#1;2;3;4;5;1;\x7F;#",      // DEL
      kBorder + kWall + "x",
      kBorder + kWall + "obstacle;8;1;0;;",
      kBorder + kWall.substr(0, kWall.size() - 2),
      kBorder + std::string(1, '\0') + kWall,
  };
  for (const auto& text : texts) EXPECT_FALSE(shown(text)) << text;
}

TEST(ObstacleStream, EndsWhenNobodyLooksAnyLonger) {
  int count = 0;
  const std::string text = kBorder + kWall + kWall + kWall;
  EXPECT_FALSE(visit_obstacles(text, [&](const ObstacleView&) { return ++count < 2; }));
  EXPECT_EQ(count, 2);
}

// Writes numbers short and long, attributes that change and that stay.
TEST(ObstacleStream, ShowsWhatReadingGives) {
  Random random(111);
  int plain = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = format_map(test::random_map(random, {6, 12}));
    const auto map = shown(text);
    const MapDocument document = read_map(text);
    if (map) {
      ++plain;
      ASSERT_TRUE(document.findings.empty()) << text;
      ASSERT_EQ(*map, document.map) << text;
    }
  }
  EXPECT_GT(plain, 2900);
}

// Line breaks may be missing or more; everywhere, or here and there.
TEST(ObstacleStream, ShowsTheSameMapWhateverTheLineBreaks) {
  Random random(113);
  for (int i = 0; i < 1000; ++i) {
    const Map map = test::random_map(random, {6, 12});
    if (!shown(format_map(map))) continue;
    for (const std::uint64_t share : {1, 2, 20}) {
      for (const std::string_view instead : {"", "\n\n", "\r\n"}) {
        std::string text;
        for (const char c : format_map(map)) {
          if (c == '\n' && random.below(share) == 0)
            text += instead;
          else
            text += c;
        }
        const auto map_shown = shown(text);
        ASSERT_TRUE(map_shown) << text;
        ASSERT_EQ(*map_shown, quantized(map)) << text;
      }
    }
  }
}

// Whatever hands do to a text: what is shown as plain is what the reader finds no defect in.
TEST(ObstacleStream, IsNeverSurerThanTheReader) {
  static constexpr std::string_view kBytes = "0123456789-.;#\n \tobe\x01\xC3,+\r";
  Random random(112);
  int plain = 0, damaged = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = format_map(test::random_map(random, {3, 5}));
    for (auto edits = 1 + random.below(2); edits > 0; --edits) {
      const auto at = random.below(text.size());
      const char byte = kBytes[random.below(kBytes.size())];
      switch (random.below(3)) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        default:
          text.erase(at, 1);
      }
    }
    const auto map = shown(text);
    const MapDocument document = read_map(text);
    damaged += document.findings.empty() ? 0 : 1;
    if (!map) continue;
    ++plain;
    ASSERT_TRUE(document.findings.empty()) << text;
    ASSERT_EQ(*map, document.map) << text;
  }
  EXPECT_GT(plain, 2000);
  EXPECT_GT(damaged, 2000);
}

TEST(ObstacleStream, LetsPiecesGoAndTellsHowFarItIs) {
  std::string text = kBorder;
  while (text.size() < 3 << 18) text += kWall;
  const auto keeper = std::make_shared<test::Keeper>();
  std::vector<std::size_t> steps;
  const auto progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, text.size() >> 10U);
    steps.push_back(done);
  };
  EXPECT_TRUE(visit_obstacles(
      MapText(text, keeper), [](const ObstacleView&) { return true; }, progress));
  EXPECT_GE(keeper->released + 1, text.size());  // but for the line break at the end
  ASSERT_GE(steps.size(), 3U);
  EXPECT_EQ(steps.back(), text.size() >> 10U);
}

}  // namespace
}  // namespace mapwright
