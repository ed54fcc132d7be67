#include "mapcore/text/decimal.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "mapcore/random.hpp"
#include "mapcore/text/short_point.hpp"

namespace mapwright::text {
namespace {

std::string random_digits(Random& random, std::uint64_t most) {
  std::string digits;
  for (auto left = random.below(most + 1); left > 0; --left) {
    digits += static_cast<char>('0' + random.below(10));
  }
  return digits;
}

// Any shape a decimal can have: few digits mostly, sometimes more than a double holds.
std::string random_decimal(Random& random) {
  const std::uint64_t most = random.below(8) == 0 ? 30 : 8;
  std::string text = random.below(2) == 0 ? "-" : "";
  text += random_digits(random, most);
  if (random.below(4) != 0) text += "." + random_digits(random, most);
  if (random.below(10) == 0) {
    text += "e" + std::to_string(static_cast<int>(random.below(700)) - 350);
  }
  return text;
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST(ShortDecimal, EqualsFromCharsBitForBit) {
  Random random(30);
  std::size_t taken = 0;
  for (int i = 0; i < 3'000'000; ++i) {
    const std::string text = random_decimal(random);
    std::string padded = text + ";";
    padded.resize(padded.size() + kShortDecimalBytes, ';');
    double quick = 0.0;
    const char* const end = read_short_decimal(padded.data(), quick);
    if (end == nullptr) continue;
    ++taken;
    double exact = 0.0;
    const auto [stop, error] = std::from_chars(padded.data(), end, exact);
    ASSERT_EQ(error, std::errc{}) << text;
    ASSERT_EQ(stop, end) << text;
    ASSERT_EQ(bits(quick), bits(exact + 0.0)) << text;
    ASSERT_TRUE(*end == ';' || *end == 'e' || *end == '.') << text;
  }
  EXPECT_GT(taken, 1'000'000U);
}

TEST(ShortPoint, EqualsItsTwoNumbersBitForBit) {
  Random random(31);
  std::size_t taken = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const std::string x = random_decimal(random), y = random_decimal(random);
    std::string padded = x + ";" + y + ";";
    const std::size_t size = padded.size();
    padded.resize(size + kShortPointBytes, "9;.-"[random.below(4)]);
    Point point;
    const char* const end = read_short_point(padded.data(), point);
    if (end == nullptr) continue;
    ++taken;
    ASSERT_EQ(end, padded.data() + size) << padded;
    ASSERT_EQ(bits(point.x), bits(read_number(x).value)) << padded;
    ASSERT_EQ(bits(point.y), bits(read_number(y).value)) << padded;
  }
#if defined(__SSE2__)
  EXPECT_GT(taken, 30'000U);
#endif
}

// Of two, three and more digits, and each shape that is nearly one.
TEST(ShortPoint, TakesPlainDecimalsOnly) {
  const auto is_taken = [](std::string text) {
    text.resize(text.size() + kShortPointBytes, '#');
    Point point;
    return read_short_point(text.data(), point) != nullptr;
  };
#if defined(__SSE2__)
  EXPECT_TRUE(is_taken("0.5;-1.25;"));
  EXPECT_TRUE(is_taken("-12345.678;1.2345678;"));
  EXPECT_TRUE(is_taken("1234567.8;-0.0;"));
#endif
  for (const char* text :
       {"5;1.5;", "1.5;5;", ".5;1.5;", "5.;1.5;", "1.5;.5;", "--1.5;1.5;", "1.5;-;", "1.5 ;1.5;",
        "1.5; 1.5;", "1.5;1.5", "1.5;1.5#", "123456.789;1.5;", "1.5;12345.6789;", "1.5e3;1.5;",
        "+1.5;1.5;", "1-5;1.5;", "1.5;1.5.5;", "1.5,1.5;", ";;", "", "1.5;\n1.5;"}) {
    EXPECT_FALSE(is_taken(text)) << text;
  }
}

TEST(Number, EqualsStrtodBitForBit) {
  Random random(31);
  for (int i = 0; i < 500'000; ++i) {
    const std::string text = random_decimal(random);
    char* end = nullptr;
    const double expected = std::strtod(text.c_str(), &end);
    const bool is_number = end != text.c_str() && *end == '\0';
    const auto [status, value] = read_number(text);
    if (!is_number) {
      ASSERT_EQ(status, NumberStatus::kInvalid) << text;
    } else if (std::isinf(expected)) {
      ASSERT_EQ(status, NumberStatus::kOutOfRange) << text;
    } else {
      ASSERT_EQ(status, NumberStatus::kOk) << text;
      ASSERT_EQ(bits(value), bits(expected + 0.0)) << text;
    }
  }
}

TEST(Number, TakesTheGrammarAndNothingElse) {
  for (const char* text :
       {"0", "-4", "+4", "5.", ".5", "-.5", "+.5", "1e3", "1E+3", "1e-3", "007"}) {
    EXPECT_EQ(read_number(text).status, NumberStatus::kOk) << text;
    EXPECT_EQ(read_number(text).value, std::strtod(text, nullptr)) << text;
  }
  for (const char* text : {"", "-", "+", ".", "e5", "1e", "1,5", "1 ", " 1", "0x1p3", "1.2.3",
                           "+-1", "++1", "1f", "1_000", "1'000"}) {
    EXPECT_EQ(read_number(text).status, NumberStatus::kInvalid) << text;
  }
  for (const char* text : {"inf", "-inf", "INFINITY", "nan", "NaN", "-nan"}) {
    EXPECT_EQ(read_number(text).status, NumberStatus::kNonFinite) << text;
  }
}

TEST(Number, TellsHugeFromTiny) {
  const std::string zeros(400, '0');
  for (const std::string& text :
       std::vector<std::string>{"1e400", "-1e400", "1" + zeros, "1" + zeros + ".5", "0.1e999",
                                "1e99999999999999999999"}) {
    EXPECT_EQ(read_number(text).status, NumberStatus::kOutOfRange) << text;
  }
  for (const std::string& text :
       std::vector<std::string>{"1e-400", "-1e-400", "0." + zeros + "1", "1" + zeros + "e-900",
                                "1e-99999999999999999999"}) {
    EXPECT_EQ(read_number(text).status, NumberStatus::kOk) << text;
    EXPECT_EQ(bits(read_number(text).value), bits(0.0)) << text;
  }
  EXPECT_EQ(read_number("1" + zeros + "e-400").value, 1.0);
  EXPECT_EQ(read_number("0e999").value, 0.0);
}

TEST(Number, HasNoNegativeZero) {
  EXPECT_EQ(bits(read_number("-0").value), bits(0.0));
  EXPECT_EQ(bits(read_number("-0.000").value), bits(0.0));
}

TEST(Integer, TakesWholeNumbersOnly) {
  EXPECT_EQ(read_integer("26").value, 26);
  EXPECT_EQ(read_integer("+26").value, 26);
  EXPECT_EQ(read_integer("-9223372036854775808").value, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(read_integer("9223372036854775808").status, NumberStatus::kOutOfRange);
  for (const char* text : {"", "-", "+", "1.0", "1e3", "one", "1 2", "+-1", "0x1"}) {
    EXPECT_EQ(read_integer(text).status, NumberStatus::kInvalid) << text;
  }
}

}  // namespace
}  // namespace mapwright::text
