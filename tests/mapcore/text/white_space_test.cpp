// What carries no meaning: line ends, byte order mark, white space around fields, the locale.
#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <sstream>
#include <string>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/mapcore/text/samples.hpp"
#include "tests/support/random_map.hpp"

namespace mapwright {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

class WhiteSpace : public testing::TestWithParam<std::string> {};

TEST_P(WhiteSpace, InPlaceOfLineBreaksChangesNothing) {
  Random random(60);
  for (int i = 0; i < 200; ++i) {
    const std::string text = format_map(test::random_map(random));
    const MapDocument document = read_map(replaced(text, "\n", GetParam()));
    ASSERT_EQ(document.map, read_map(text).map) << document.text.view();
    ASSERT_TRUE(document.findings.empty()) << document.text.view();
  }
}

INSTANTIATE_TEST_SUITE_P(Text, WhiteSpace,
                         testing::Values("\r\n", "\r", "", " ", "\t\v\f ", "\n\n\n"));

TEST(WhiteSpaceAroundFields, ChangesNothing) {
  const std::string text = test::kTriangle;
  const auto plain = read_map(text).map;
  EXPECT_EQ(read_map(replaced(text, ";", " ; ")).map, plain);
  EXPECT_EQ(read_map(replaced(text, "#", "\t#\t")).map, plain);
  EXPECT_EQ(read_map("\xEF\xBB\xBF" + text).map, plain);
  EXPECT_EQ(read_map("\xEF\xBB\xBF\r\n" + replaced(text, "\n", "\r\n")).map, plain);
  EXPECT_TRUE(read_map("\xEF\xBB\xBF\r\n" + replaced(text, ";", "\n;\n")).findings.empty());
}

// Numbers with decimal comma and thousands separators, for streams and for the C library.
struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Locale, ChangesNothing) {
  const std::string text = "border;\n-4000.5;58;\n58;-4;\n#\n";
  const std::locale old_locale =
      std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  const std::string old_c_locale = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  const MapDocument document = read_map(text);
  std::ostringstream out;
  write_map(document.map, out);
  std::setlocale(LC_ALL, old_c_locale.c_str());
  std::locale::global(old_locale);
  EXPECT_TRUE(document.findings.empty());
  EXPECT_EQ(document.map.border, (Border{-4000.5, 58, 58, -4}));
  EXPECT_EQ(out.str(), text);
}

TEST(SanitizedSemantic, HasNothingTheFormatReserves) {
  EXPECT_EQ(sanitized_semantic("wall,orange"), "wall,orange");
  EXPECT_EQ(sanitized_semantic("wall;orange"), "wall,orange");
  EXPECT_EQ(sanitized_semantic("house #3\r\nleft\x01"), "house  3  left");
  EXPECT_EQ(sanitized_semantic("Pla\xC3\xA7"
                               "a\tgran"),
            "Pla\xC3\xA7"
            "a gran");
  EXPECT_EQ(sanitized_semantic(" \n"), "");
}

}  // namespace
}  // namespace mapwright
