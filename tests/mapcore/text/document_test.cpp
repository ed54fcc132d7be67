#include "mapcore/text/document.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mapcore/random.hpp"
#include "mapcore/text/reader.hpp"
#include "tests/mapcore/text/samples.hpp"

namespace mapwright {
namespace {

using test::kTriangle;
using test::with;

// The definition, byte by byte.
TextPlace counted_place(const std::string& text, std::size_t offset) {
  TextPlace place;
  for (std::size_t i = 0; i < offset; ++i) {
    const bool is_continuation = (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
    if (text[i] == '\n') {
      place = {place.line + 1, 1};
    } else if (!is_continuation) {
      ++place.column;
    }
  }
  return place;
}

TEST(TextIndex, CountsLinesAndCodePoints) {
  Random random(50);
  std::string text;
  const char* const pieces[] = {"a", "\n", "\xC3\xA9", "\xE5\xBB\xBA", "\xF0\x9F\xA4\x96", ";"};
  while (text.size() < 30'000) {
    text += pieces[random.below(6)];
    if (random.below(2000) == 0) text += std::string(6000, 'x');  // lines longer than a block
  }
  const TextIndex index(text);
  for (std::size_t offset = 0; offset <= text.size(); offset += 1 + random.below(9)) {
    if ((static_cast<unsigned char>(text[offset]) & 0xC0U) == 0x80U) continue;
    ASSERT_EQ(index.place_at(text, offset), counted_place(text, offset)) << offset;
    ASSERT_EQ(index.offset_at(text, counted_place(text, offset)), offset);
  }
}

TEST(TextIndex, FindsNoOffsetBeyondLineAndText) {
  const std::string text = "ab\n\xC3\xA9\n";
  const TextIndex index(text);
  EXPECT_EQ(index.offset_at(text, {1, 9}), 2U);
  EXPECT_EQ(index.offset_at(text, {2, 2}), 5U);
  EXPECT_EQ(index.offset_at(text, {9, 1}), text.size());
  EXPECT_EQ(TextIndex("").offset_at("", {1, 1}), 0U);
}

TEST(TextIndex, ByteOrderMarkTakesNoColumn) {
  const std::string text =
      "\xEF\xBB\xBF"
      "border;";
  EXPECT_EQ(TextIndex(text).place_at(text, 3), (TextPlace{1, 1}));
  EXPECT_EQ(TextIndex(text).place_at(text, 9), (TextPlace{1, 7}));
  EXPECT_EQ(TextIndex(text).offset_at(text, {1, 1}), 3U);
  EXPECT_EQ(TextIndex(text).offset_at(text, {1, 7}), 9U);
}

TEST(TextIndex, KnowsEveryField) {
  const auto document = read_map(kTriangle);
  const auto& [text, map, index, findings] = document;
  EXPECT_EQ(index.border_place(text), (TextPlace{2, 1}));
  EXPECT_EQ(index.place(text, 0, ObstacleField::kKeyword), (TextPlace{5, 1}));
  EXPECT_EQ(index.place(text, 0, ObstacleField::kId), (TextPlace{6, 1}));
  EXPECT_EQ(index.place(text, 0, ObstacleField::kShapeType), (TextPlace{6, 3}));
  EXPECT_EQ(index.place(text, 0, ObstacleField::kSegmentCount), (TextPlace{6, 5}));
  EXPECT_EQ(index.place(text, 0, ObstacleField::kSemantic), (TextPlace{6, 7}));
  EXPECT_EQ(index.place(text, 0, 1, SegmentField::kAx), (TextPlace{12, 1}));
  EXPECT_EQ(index.place(text, 0, 1, SegmentField::kAy), (TextPlace{12, 3}));
  EXPECT_EQ(index.place(text, 0, 1, SegmentField::kBx), (TextPlace{13, 1}));
  EXPECT_EQ(index.place(text, 0, 1, SegmentField::kBy), (TextPlace{13, 3}));
  EXPECT_EQ(index.place(text, 0, 2, SegmentField::kHeight), (TextPlace{18, 1}));
  EXPECT_EQ(index.place(text, 0, 2, SegmentField::kInOut), (TextPlace{18, 3}));
  EXPECT_EQ(index.place(text, 0, 2, SegmentField::kSemantic), (TextPlace{18, 5}));
}

TEST(TextIndex, KnowsTheFieldsOfRepairedRecords) {
  const auto one_line = read_map(with(kTriangle, "obstacle;\n1", ". obstacle 1"));
  EXPECT_EQ(one_line.index.place(one_line.text, 0, ObstacleField::kKeyword), (TextPlace{5, 3}));
  EXPECT_EQ(one_line.index.place(one_line.text, 0, ObstacleField::kId), (TextPlace{5, 12}));
  EXPECT_EQ(one_line.index.place(one_line.text, 0, ObstacleField::kShapeType), (TextPlace{5, 14}));

  const auto lost_hash = read_map(with(kTriangle, "wall;\n#\n", "wall; "));
  EXPECT_EQ(lost_hash.index.place(lost_hash.text, 0, 1, SegmentField::kAx), (TextPlace{10, 11}));

  const auto no_semantic = read_map(with(kTriangle, "5;1;door;\n#", "5;1;\n #"));
  EXPECT_EQ(no_semantic.index.place(no_semantic.text, 0, 1, SegmentField::kSemantic),
            (TextPlace{15, 2}));

  const auto no_numbers = read_map("border;#");
  EXPECT_EQ(no_numbers.index.border_place(no_numbers.text), (TextPlace{1, 1}));
  const auto no_border = read_map("obstacle;1;1;0;a;#");
  EXPECT_EQ(no_border.index.border_place(no_border.text), (TextPlace{1, 1}));
}

}  // namespace
}  // namespace mapwright
