#include "mapcore/text/decimal_format.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "mapcore/text/digits.hpp"

namespace mapwright::text {
namespace {

constexpr int kSignificantDigits = 9;
constexpr double kMostMultiples = 0x1p50;
constexpr double kMostUnits = 9.0e18;
constexpr double kMostSmallUnits = std::numeric_limits<std::int32_t>::max();

std::uint64_t power_of_ten(int exponent) {
  std::uint64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

// Nearest whole number, ties to even: adding 1.5 · 2^52 leaves no bits for a fraction. Requires
// |value| < 2^51.
double nearest_whole(double value) {
  constexpr double kNoFraction = 0x1.8p52;
  return (value + kNoFraction) - kNoFraction;
}

char* write_three_digits(char* out, std::uint64_t number) {
  std::memcpy(out, kThreeDigits[number].digits, 3);
  return out + 3;
}

// Copies four bytes where three are wanted at most: shorter than a loop.
char* write_below_thousand(char* out, std::uint64_t number) {
  const auto& entry = kThreeDigits[number];
  const int skip = 3 - entry.without_leading_zeros;
  std::memcpy(out, entry.digits + skip, 3 - static_cast<std::size_t>(skip));
  return out + entry.without_leading_zeros;
}

char* write_whole(char* out, std::uint64_t number) {
  if (number < 1000) return write_below_thousand(out, number);
  if (number < 1'000'000) {
    return write_three_digits(write_below_thousand(out, number / 1000), number % 1000);
  }
  return std::to_chars(out, out + 20, number).ptr;
}

// '.' and the decimals, without trailing zeros.
char* write_fraction(char* out, std::uint64_t fraction, int decimals) {
  *out++ = '.';
  char* const end = out + decimals;
  for (char* at = end; at != out; fraction /= 10) *--at = static_cast<char>('0' + fraction % 10);
  char* last = end;
  while (last[-1] == '0') --last;
  return last;
}

}  // namespace

DecimalFormat::DecimalFormat(double resolution) {
  assert(resolution >= 1e-9 && resolution <= 1e6);
  char buffer[32];
  const auto [end, error] = std::to_chars(std::begin(buffer), std::end(buffer), resolution,
                                          std::chars_format::scientific, kSignificantDigits - 1);
  // d.dddddddde±xx: the digits are a whole number of units 10^(xx − 8).
  const char* const e = std::find(buffer, end, 'e');
  int exponent = 0;
  std::from_chars(e[1] == '+' ? e + 2 : e + 1, end, exponent);
  step_ = buffer[0] - '0';
  for (const char* p = buffer + 2; p != e; ++p) step_ = step_ * 10 + (*p - '0');
  decimals_ = kSignificantDigits - 1 - exponent;
  for (; decimals_ > 0 && step_ % 10 == 0; --decimals_) step_ /= 10;
  units_per_one_ = power_of_ten(decimals_);
  scale_ = static_cast<double>(units_per_one_);
}

DecimalFormat::Multiple DecimalFormat::nearest_multiple(double value) const {
  const double scaled = value * scale_;
  const double multiple = step_ == 1 ? scaled : scaled / static_cast<double>(step_);
  if (!(std::abs(multiple) < kMostMultiples && std::abs(scaled) < kMostUnits)) return {};
  return {true, static_cast<std::int64_t>(nearest_whole(multiple)) * step_};
}

char* DecimalFormat::write_units(char* out, std::int64_t units) const {
  *out = '-';
  out += units < 0 ? 1 : 0;
  const auto magnitude = static_cast<std::uint64_t>(units < 0 ? -units : units);
  if (decimals_ == 3) {  // the default; a constant divisor is several times faster
    const std::uint64_t whole = magnitude / 1000;
    const bool is_short = std::endian::native == std::endian::little && whole < kEightDigits;
    out = is_short ? write_below_eight_digits(out, whole) : write_whole(out, whole);
    return write_thousandths(out, magnitude % 1000);
  }
  out = write_whole(out, magnitude / units_per_one_);
  const std::uint64_t fraction = magnitude % units_per_one_;
  return fraction == 0 ? out : write_fraction(out, fraction, decimals_);
}

char* DecimalFormat::write(char* out, double value) const {
  assert(std::isfinite(value));
  const Multiple multiple = nearest_multiple(value);
  if (multiple.fits) return write_units(out, multiple.units);
  return std::to_chars(out, out + kMaxCharacters, value, std::chars_format::fixed).ptr;
}

double DecimalFormat::rounded(double value) const {
  const Multiple multiple = nearest_multiple(value);
  if (!multiple.fits) return value;
  // Both operands exact: one rounding, as in reading (decimal.hpp).
  constexpr std::int64_t kExactUnits = std::int64_t{1} << 53;
  if (std::abs(multiple.units) <= kExactUnits) return static_cast<double>(multiple.units) / scale_;
  char buffer[kMaxCharacters];
  const char* const end = write_units(buffer, multiple.units);
  double read = 0.0;
  std::from_chars(buffer, end, read);
  return read;
}

// Without whole numbers in between, so that several go at a time: where `rounded` makes one of a
// multiple, the multiple is below 2^50 and a double holds it.
void DecimalFormat::round(std::span<double> values) const {
  bool is_simple = step_ == 1;
  for (const double value : values) {
    is_simple = is_simple & (std::abs(value * scale_) < kMostMultiples);
  }
  if (!is_simple) {
    for (double& value : values) value = rounded(value);
    return;
  }
  // −0 becomes 0.
  for (double& value : values) value = (nearest_whole(value * scale_) + 0.0) / scale_;
}

bool DecimalFormat::units_of(std::span<const double> values, std::int32_t* units) const {
  bool fit = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double whole = nearest_whole(values[i] * scale_);
    const bool fits = std::abs(whole) <= kMostSmallUnits;
    units[i] = static_cast<std::int32_t>(fits ? whole : 0.0);
    fit = fit & fits & (of_units(units[i]) == values[i]) & (units[i] % step_ == 0);
  }
  return fit;
}

bool DecimalFormat::round(std::span<double> values, std::int32_t* units) const {
  bool is_simple = step_ == 1;
  for (const double value : values) {
    is_simple = is_simple & (std::abs(value * scale_) < kMostSmallUnits);
  }
  if (!is_simple) {
    round(values);
    return units_of(values, units);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double whole = nearest_whole(values[i] * scale_) + 0.0;  // −0 becomes 0
    units[i] = static_cast<std::int32_t>(whole);
    values[i] = whole / scale_;
  }
  return true;
}

}  // namespace mapwright::text
