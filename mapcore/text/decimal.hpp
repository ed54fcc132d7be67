// Reading decimal numbers: exactly, and fast where they are short.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace mapwright::text {

enum class NumberStatus : std::uint8_t {
  kOk,
  kInvalid,     ///< not a number of the grammar
  kNonFinite,   ///< infinity or not-a-number in words
  kOutOfRange,  ///< larger than the type can hold
};

template <class T>
struct NumberReading {
  NumberStatus status = NumberStatus::kInvalid;
  T value{};
};

/// The nearest double of a decimal such as "-4", "+12.50", ".5" or "1e-3", in every locale; all of
/// `text` must be the number. Too small to tell from 0 reads as 0; "-0" reads as 0.
NumberReading<double> read_number(std::string_view text);

/// A whole number: digits with an optional sign.
NumberReading<std::int64_t> read_integer(std::string_view text);

/// Bytes that `read_short_decimal` may look at.
inline constexpr std::size_t kShortDecimalBytes = 24;

namespace detail {

inline constexpr std::array<std::uint64_t, 8> kPowersOfTen{1,      10,      100,       1000,
                                                           10'000, 100'000, 1'000'000, 10'000'000};
inline constexpr std::array<double, 8> kDoublePowersOfTen{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};

/// Eight bytes of text, each digit replaced by its value.
inline std::uint64_t load_digits(const char* p) {
  std::uint64_t word = 0;
  std::memcpy(&word, p, sizeof word);
  return word ^ 0x3030303030303030U;
}

/// How many of the eight bytes, from the first one on, are digits.
inline unsigned leading_digits(std::uint64_t word) {
  const std::uint64_t above_nine = ((word & 0x7F7F7F7F7F7F7F7FU) + 0x7676767676767676U) | word;
  return static_cast<unsigned>(std::countr_zero(above_nine & 0x8080808080808080U)) / 8U;
}

/// Value of the first `count` digits, 1 <= count <= 8 (D. Lemire, "Quickly parsing eight digits").
inline std::uint64_t digits_value(std::uint64_t word, unsigned count) {
  word <<= 64U - 8U * count;
  word = word * 10U + (word >> 8U);
  constexpr std::uint64_t kMask = 0x000000FF000000FF;
  return ((word & kMask) * 0x000F424000000064U + ((word >> 16U) & kMask) * 0x0000271000000001U) >>
         32U;
}

}  // namespace detail

/// Reads a decimal with one to seven digits before the point and none or one to seven behind it.
/// Returns the end of the number, or nullptr where it has another shape. At least
/// kShortDecimalBytes must be readable.
///
/// Exact: at most 14 digits fit a double's 53 bits and so does the power of ten, hence the one
/// division rounds once (W. D. Clinger, "How to read floating point numbers accurately", 1990).
inline const char* read_short_decimal(const char* p, double& value) {
  if constexpr (std::endian::native != std::endian::little) return nullptr;
  const bool negative = *p == '-';
  p += negative ? 1 : 0;
  const std::uint64_t whole = detail::load_digits(p);
  const unsigned whole_count = detail::leading_digits(whole);
  if (whole_count - 1U >= 7U) return nullptr;
  auto mantissa = detail::digits_value(whole, whole_count);
  p += whole_count;
  double magnitude = 0.0;
  if (*p == '.') {
    const std::uint64_t fraction = detail::load_digits(p + 1);
    const unsigned count = detail::leading_digits(fraction);
    if (count - 1U >= 7U) return nullptr;
    mantissa = mantissa * detail::kPowersOfTen[count] + detail::digits_value(fraction, count);
    magnitude = static_cast<double>(static_cast<std::int64_t>(mantissa)) /
                detail::kDoublePowersOfTen[count];
    p += count + 1;
  } else {
    magnitude = static_cast<double>(static_cast<std::int64_t>(mantissa));
  }
  value = (negative ? -magnitude : magnitude) + 0.0;  // −0 becomes 0
  return p;
}

/// Reads a whole number of one to seven digits without sign. Returns its end, or nullptr where it
/// has another shape. At least kShortDecimalBytes must be readable.
inline const char* read_short_integer(const char* p, std::int64_t& value) {
  if constexpr (std::endian::native != std::endian::little) return nullptr;
  const std::uint64_t digits = detail::load_digits(p);
  const unsigned count = detail::leading_digits(digits);
  if (count - 1U >= 7U) return nullptr;
  value = static_cast<std::int64_t>(detail::digits_value(digits, count));
  return p + count;
}

}  // namespace mapwright::text
