// Long texts are read piece by piece: what stands where two pieces meet is read as anywhere else.
#include <gtest/gtest.h>

#include <string>

#include "mapcore/random.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/mapcore/text/keeper.hpp"

namespace mapwright {
namespace {

constexpr std::size_t kPiece = 64 * TextIndex::kBlockBytes;

// Walls enough for `pieces` pieces and some more.
std::string long_text(std::size_t pieces) {
  std::string text = "border;\n0;9;\n9;0;\n#\n";
  for (int id = 1; text.size() < pieces * kPiece + kPiece / 3; ++id) {
    const int count = 1 + id % 90;
    text +=
        "obstacle;\n" + std::to_string(id) + ";2;" + std::to_string(count) + ";wall,glass;\n#\n";
    for (int k = 0; k < count; ++k) {
      text += std::to_string(k) + ".25;1;\n" + std::to_string(k + 1) + ".25;1;\n" +
              std::to_string(2 + k % 3) + ";1;grey;\n#\n";
    }
  }
  return text;
}

TEST(Pieces, ArePutTogetherToTheWholeMap) {
  const std::string text = long_text(3);
  const MapDocument document = read_map(text);
  EXPECT_TRUE(document.findings.empty());
  EXPECT_EQ(format_map(document.map), text);
}

TEST(Pieces, AreLetGoOneAfterTheOther) {
  const std::string text = long_text(3);
  const auto keeper = std::make_shared<test::Keeper>();
  const MapDocument document = read_map(MapText(text, keeper));
  EXPECT_EQ(keeper->released, text.size());
  EXPECT_EQ(document.map, read_map(text).map);
}

// Whatever stands across the end of a piece, one byte after the other.
TEST(Pieces, MayEndAnywhere) {
  const std::string text = long_text(1);
  const Map map = read_map(text).map;
  for (std::size_t blanks = 0; blanks < 120; ++blanks) {
    const MapDocument document = read_map(std::string(blanks, ' ') + text);
    ASSERT_TRUE(document.findings.empty()) << blanks;
    ASSERT_EQ(document.map, map) << blanks;
  }
}

TEST(Pieces, WithoutRecordEndAreReadTogether) {
  std::string text = long_text(0);
  text += std::string(3 * kPiece, ' ') + "obstacle;7777;2;1;wall;#1;1;2;1;3;1;;#";
  const MapDocument document = read_map(text);
  EXPECT_TRUE(document.findings.empty());
  EXPECT_EQ(document.map.obstacles.back().id, 7777);
}

// Every record is found again, also those that are counted from a record far before them.
TEST(Pieces, HaveAPlaceForEverySegment) {
  const std::string text = long_text(2);
  const MapDocument document = read_map(text);
  std::size_t line = 4;
  for (std::size_t i = 0; i < document.map.obstacles.size(); ++i) {
    line += 3;
    for (std::size_t k = 0; k < document.map.obstacles[i].segments.size(); ++k) {
      line += k == 0 ? 1 : 4;
      const TextPlace expected{line, 1};
      ASSERT_EQ(document.index.place(document.text, i, k, SegmentField::kAx), expected);
    }
    line += 3;
  }
}

TEST(Pieces, KeepWhatIsNotTextOut) {
  std::string text = long_text(2);
  const std::size_t at = kPiece + 10 * TextIndex::kBlockBytes;
  text.replace(at, 5000, std::string(5000, '\x01'));
  const MapDocument document = read_map(text);
  ASSERT_EQ(document.findings.size(), 2U);  // the obstacle that is cut, and where
  EXPECT_EQ(document.findings[0].code, FindingCode::F113);
  EXPECT_EQ(document.findings[1].code, FindingCode::F102);
  EXPECT_EQ(document.index.offset_at(document.text, *document.findings[1].place), at);
}

}  // namespace
}  // namespace mapwright
