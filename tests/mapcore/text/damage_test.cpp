// Damage of every kind: the reader never crashes, never stays silent about what is lost, and every
// place it names lies in the text.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mapcore/random.hpp"
#include "mapcore/text/characters.hpp"
#include "mapcore/text/encoding.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/mapcore/text/samples.hpp"
#include "tests/support/random_map.hpp"

namespace mapwright {
namespace {

std::size_t line_count(std::string_view text) {
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// What must hold for every text whatsoever.
void check(const MapDocument& document) {
  const auto& index = document.index;
  const std::size_t lines = line_count(document.text);
  for (const auto& finding : document.findings) {
    ASSERT_TRUE(finding.place.has_value());
    ASSERT_LE(finding.place->line, lines);
    ASSERT_GE(finding.place->column, 1U);
    ASSERT_LE(finding.place->column, document.text.size() + 1);
    ASSERT_EQ(text::find_invalid_utf8(finding.message), std::string::npos);
  }
  ASSERT_EQ(index.obstacle_offsets.size(), document.map.obstacles.size());
  // Whatever was understood can be written and read again.
  const std::string written = format_map(document.map);
  if (text::end_of_text(written) < written.size()) return;  // labels of control characters
  ASSERT_EQ(read_map(written).map, quantized(document.map));
}

TEST(Damage, TruncationIsNeverSilent) {
  const std::string text = test::kTriangle;
  const std::size_t header = text.find("obstacle");
  const std::size_t whole = text.rfind('#') + 1;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const MapDocument document = read_map(text.substr(0, size));
    check(document);
    const bool border_alone = size + 1 == header || size == header;
    EXPECT_EQ(document.findings.empty(), border_alone || size >= whole) << size;
  }
}

TEST(Damage, RandomMutationsDoNoHarm) {
  Random random(20);
  constexpr std::string_view kLikely = ";;##\n\r .-+eE0159,\"\xC3\xA9\x00obstacle";
  for (int round = 0; round < 20'000; ++round) {
    std::string text = round % 4 == 0 ? format_map(test::random_map(random)) : test::kTriangle;
    for (auto left = 1 + random.below(8); left > 0 && !text.empty(); --left) {
      const std::size_t at = random.below(text.size());
      const std::size_t length = std::min<std::size_t>(1 + random.below(12), text.size() - at);
      const char byte = random.below(8) == 0 ? static_cast<char>(random())
                                             : kLikely[random.below(kLikely.size())];
      switch (random.below(4)) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        case 2:
          text.erase(at, length);
          break;
        default:
          text.insert(random.below(text.size()), text.substr(at, length));
          break;
      }
    }
    ASSERT_NO_FATAL_FAILURE(check(read_map(text))) << "round " << round << ":\n" << text;
  }
}

TEST(Damage, RandomBytesAreNoText) {
  Random random(21);
  for (int round = 0; round < 200; ++round) {
    std::string text(64 + random.below(20'000), '\0');
    for (char& c : text) c = static_cast<char>(random());
    const MapDocument document = read_map(text);
    ASSERT_EQ(document.findings.size(), 1U);
    ASSERT_EQ(document.findings[0].code, FindingCode::F102);
  }
}

TEST(Damage, LongRunsOfAnythingEnd) {
  for (const char* piece :
       {";", "#", "1;", "obstacle", "obstacle;", "obstacle;1;1;1;a;", "0;0;1;0;5;1;a;",
        "0;0;1;0;5;1;a;#", " ", "\"", "a ", "-", "1e", "\xC3", "border;"}) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += piece;
    ASSERT_NO_FATAL_FAILURE(check(read_map(text))) << piece;
  }
}

}  // namespace
}  // namespace mapwright
