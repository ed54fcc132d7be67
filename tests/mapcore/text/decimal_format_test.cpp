#include "mapcore/text/decimal_format.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "mapcore/random.hpp"
#include "mapcore/text/decimal.hpp"

namespace mapwright::text {
namespace {

std::string formatted(const DecimalFormat& format, double value) {
  char buffer[DecimalFormat::kMaxCharacters];
  return {buffer, format.write(buffer, value)};
}

std::string formatted(double resolution, double value) {
  return formatted(DecimalFormat(resolution), value);
}

TEST(DecimalFormat, WritesTheFewestDecimals) {
  EXPECT_EQ(formatted(0.001, 12.10), "12.1");
  EXPECT_EQ(formatted(0.001, 58.0), "58");
  EXPECT_EQ(formatted(0.001, -0.5), "-0.5");
  EXPECT_EQ(formatted(0.001, 0.007), "0.007");
  EXPECT_EQ(formatted(0.001, 0.070), "0.07");
  EXPECT_EQ(formatted(0.001, 999.9996), "1000");
  EXPECT_EQ(formatted(0.001, 1234567.891), "1234567.891");
  EXPECT_EQ(formatted(0.001, -4582230.05), "-4582230.05");
}

TEST(DecimalFormat, NeverWritesNegativeZero) {
  for (const double resolution : {1e-9, 0.001, 0.005, 0.5, 1.0, 1000.0}) {
    EXPECT_EQ(formatted(resolution, -0.0), "0");
    EXPECT_EQ(formatted(resolution, -0.4 * resolution), "0");
  }
}

TEST(DecimalFormat, RoundsToMultiplesOfAnyResolution) {
  EXPECT_EQ(formatted(0.005, 1.0024), "1");
  EXPECT_EQ(formatted(0.005, 1.0026), "1.005");
  EXPECT_EQ(formatted(0.5, 12.3), "12.5");
  EXPECT_EQ(formatted(0.25, -12.3), "-12.25");
  EXPECT_EQ(formatted(1.0, 12.7), "13");
  EXPECT_EQ(formatted(10.0, 126.0), "130");
  EXPECT_EQ(formatted(1e6, 1.4e6), "1000000");
  EXPECT_EQ(formatted(1e-9, 0.1234567894), "0.123456789");
  EXPECT_EQ(formatted(1.0 / 3.0, 1.0), "0.999999999");
}

TEST(DecimalFormat, LeavesNumbersBeyondItsReachAsTheyAre) {
  EXPECT_EQ(formatted(0.001, 1e15), "1000000000000000");
  EXPECT_EQ(formatted(0.001, 1e19), "10000000000000000000");
  EXPECT_EQ(formatted(0.001, -1e25), "-10000000000000000905969664");
  for (const double huge : {1e18, 9.3e18, -1e19, 1.7976931348623157e308}) {
    EXPECT_EQ(read_number(formatted(0.001, huge)).value, huge);
  }
}

// Nearest multiple, fewest digits, and `rounded` tells what will be read.
TEST(DecimalFormat, HoldsItsPromisesOnRandomNumbers) {
  Random random(40);
  for (const double resolution : {1e-6, 0.001, 0.005, 0.25, 1.0, 7.0}) {
    const DecimalFormat format(resolution);
    for (int i = 0; i < 100'000; ++i) {
      const double value =
          std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(24)));
      const std::string text = formatted(format, value);
      const double read = read_number(text).value;
      ASSERT_EQ(read, format.rounded(value)) << text;
      ASSERT_LE(std::abs(read - value), resolution * 0.5 + 1e-15 * std::abs(value)) << text;
      ASSERT_EQ(formatted(format, read), text);
      ASSERT_TRUE(text.find('.') == text.npos || text.back() != '0') << text;
      ASSERT_NE(text.back(), '.');
    }
  }
}

// Every multiple of a millimetre up to 10 km, in steps that meet all last digits.
TEST(DecimalFormat, MillimetresReadBackExactly) {
  const DecimalFormat format(0.001);
  for (std::int64_t mm = -10'000'000; mm <= 10'000'000; mm += 7) {
    const double value = static_cast<double>(mm) / 1000.0;
    ASSERT_EQ(read_number(formatted(format, value)).value, value);
  }
}

// Both sides of each power of ten, and of what the short way covers.
TEST(DecimalFormat, WritesMillimetresOfAnyLength) {
  const DecimalFormat format(0.001);
  std::int64_t power = 1;
  for (int digits = 0; digits < 15; ++digits, power *= 10) {
    for (std::int64_t mm = std::max<std::int64_t>(power - 1200, 0); mm < power + 1200; ++mm) {
      std::string expected = std::to_string(mm / 1000);
      if (mm % 1000 != 0) {
        expected += "." + std::to_string(1000 + mm % 1000).substr(1);
        while (expected.back() == '0') expected.pop_back();
      }
      ASSERT_EQ(formatted(format, static_cast<double>(mm) / 1000.0), expected);
      if (mm > 0) {
        ASSERT_EQ(formatted(format, static_cast<double>(-mm) / 1000.0), "-" + expected);
      }
    }
  }
}

TEST(DecimalFormat, RoundsManyAsItRoundsOne) {
  Random random(41);
  for (const double resolution : {1e-6, 0.001, 0.005, 1.0}) {
    const DecimalFormat format(resolution);
    for (const double reach : {0.002, 20000.0, 1e18}) {
      std::vector<double> values{0.0, -0.0, -0.0004, 0.0005};
      for (int i = 0; i < 5000; ++i) values.push_back(random.uniform(-reach, reach));
      auto rounded = values;
      format.round(rounded);
      for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_EQ(rounded[i], format.rounded(values[i])) << values[i];
        ASSERT_EQ(std::signbit(rounded[i]), std::signbit(format.rounded(values[i])));
      }
    }
  }
}

// As it rounds them without, and each number of units is the number.
TEST(DecimalFormat, RoundsToUnits) {
  Random random(42);
  const std::pair<double, double> steps[] = {{1e-9, 1},  {1e-6, 1}, {0.001, 1},
                                             {0.005, 5}, {1.0, 1},  {1000.0, 1000}};
  for (const auto& [resolution, units_of_step] : steps) {
    const DecimalFormat format(resolution);
    for (const double multiples : {3.0, 1e5, 1e7, 1e10}) {
      std::vector<double> values{0.0, -0.0, -0.4 * resolution, 0.5 * resolution};
      for (int i = 0; i < 500; ++i) {
        values.push_back(random.uniform(-multiples, multiples) * resolution);
      }
      auto expected = values;
      format.round(expected);
      std::vector<std::int32_t> units(values.size()), again(values.size());
      const bool fit = format.round(values, units.data());
      ASSERT_EQ(values, expected);
      ASSERT_EQ(fit, format.units_of(values, again.data()));
      ASSERT_EQ(fit, multiples * units_of_step < 1e9) << resolution << ' ' << multiples;
      for (std::size_t i = 0; fit && i < values.size(); ++i) {
        ASSERT_EQ(again[i], units[i]);
        ASSERT_EQ(format.of_units(units[i]), values[i]);
        char buffer[DecimalFormat::kMaxCharacters];
        ASSERT_EQ(std::string(buffer, format.write_units(buffer, units[i])),
                  formatted(format, values[i]));
      }
    }
  }
}

TEST(DecimalFormat, KnowsWhatIsNoMultiple) {
  std::array<std::int32_t, 1> units{};
  const auto are_units = [&](double resolution, double value) {
    return DecimalFormat(resolution).units_of({&value, 1}, units.data());
  };
  EXPECT_TRUE(are_units(0.005, 0.015));
  EXPECT_EQ(units[0], 15);
  EXPECT_FALSE(are_units(0.005, 0.001));
  EXPECT_FALSE(are_units(0.001, 0.0015));
  EXPECT_TRUE(are_units(0.001, -2147483.647));
  EXPECT_FALSE(are_units(0.001, 2147483.648));
  EXPECT_FALSE(are_units(0.001, 1e300));
  EXPECT_FALSE(are_units(0.001, std::nan("")));
}

}  // namespace
}  // namespace mapwright::text
