// Maps are read only where something may be wrong with them; and a bar shows how far that is.
#include "cli/support/validated_map.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/cli/program_run.hpp"

namespace mapwright::cli {
namespace {

using test::TemporaryFolder;

const std::string kBorder = "border;-20;20;20;-20;#\n";

std::string square(int id, int x, const std::string& semantic) {
  const std::string left = std::to_string(x), right = std::to_string(x + 2);
  return "obstacle;" + std::to_string(id) + ";1;4;" + semantic + ";#\n" + left + ";0;" + right +
         ";0;3;1;;#\n" + right + ";0;" + right + ";2;3;1;;#\n" + right + ";2;" + left +
         ";2;3;1;;#\n" + left + ";2;" + left + ";0;3;1;;#\n";
}

TEST(ValidatedMap, IsNotReadWhereItIsSound) {
  const auto sound = validated_text(kBorder + square(1, 0, "shed"), {}, {});
  EXPECT_FALSE(sound.is_read);
  EXPECT_TRUE(sound.findings.empty());
  EXPECT_EQ(sound.document.map.border, (Border{-20.0, 20.0, 20.0, -20.0}));
  EXPECT_EQ(sound.document.text.view(), kBorder + square(1, 0, "shed"));
}

TEST(ValidatedMap, IsReadWhereSomethingMayBeWrong) {
  const auto touching =
      validated_text(kBorder + square(1, 0, "shed") + square(2, 1, "shed"), {}, {});
  EXPECT_TRUE(touching.is_read);
  EXPECT_EQ(touching.document.map.obstacles.size(), 2U);
  ASSERT_EQ(touching.findings.size(), 1U);
  EXPECT_EQ(touching.findings[0].code, FindingCode::G108);
}

TEST(ValidatedMap, IsReadWhereSourcesMatter) {
  const std::string text = kBorder + square(1, 0, "shed,source=sheds:1");
  EXPECT_FALSE(validated_text(text, {}, {}, false).is_read);
  EXPECT_TRUE(validated_text(text, {}, {}, true).is_read);
  EXPECT_FALSE(validated_text(kBorder + square(1, 0, "shed"), {}, {}, true).is_read);
}

TEST(ValidatedMap, MissesItsSidecarByTheVerb) {
  const TemporaryFolder folder;
  const auto map = folder.file("map.txt", kBorder + square(1, 0, "shed,source=sheds:1"));
  EXPECT_NE(test::run({"validate", map}).out.find("no georeference sidecar"), std::string::npos);
  const auto other = folder.file("other.txt", kBorder + square(1, 0, "shed"));
  EXPECT_EQ(test::run({"validate", other}).out, "");
}

// What the program says on a terminal, or elsewhere.
std::string said(const std::vector<std::string>& arguments, bool is_terminal) {
  std::ostringstream out, err;
  Console console(out, err, is_terminal);
  run_program(arguments, console);
  return err.str();
}

// Sheds in rows, in metres; enough of them for a map of several pieces.
std::string drawing_of_sheds() {
  std::string features;
  for (int i = 0; i < 3600; ++i) {
    const auto at = [&](int dx, int dy) {
      return "[" + std::to_string(10 * (i % 60) + dx) + "," + std::to_string(10 * (i / 60) + dy) +
             "]";
    };
    features += std::string(i > 0 ? "," : "") +
                R"({"type":"Feature","properties":{"height":3},"geometry":{"type":"Polygon",)" +
                R"("coordinates":[[)" + at(0, 0) + "," + at(2, 0) + "," + at(2, 2) + "," +
                at(0, 2) + "," + at(0, 0) + "]]}}";
  }
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

TEST(ValidatedMap, HasABarOnATerminal) {
  const TemporaryFolder folder;
  const auto drawing = folder.file("site.geojson", drawing_of_sheds());
  const std::vector<std::string> arguments{"convert", drawing, "--local", "-o",
                                           folder.path("map.txt")};
  EXPECT_NE(said(arguments, true).find("validating ["), std::string::npos);
  EXPECT_EQ(said(arguments, false).find("validating ["), std::string::npos);
}

}  // namespace
}  // namespace mapwright::cli
