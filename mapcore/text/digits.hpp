// Private to this folder: decimal digits without loops and branches.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace mapwright::text {

/// The numbers 0 to 999 as text: three digits each, and how many remain without leading zeros.
struct ThreeDigits {
  char digits[3];
  std::uint8_t without_leading_zeros;
};

/// The same as thousandths: ".012", and how many of these characters remain without trailing zeros
/// (none of ".000").
struct Thousandths {
  char text[4];
  std::uint32_t size;
};

constexpr auto three_digits_table() {
  std::array<ThreeDigits, 1000> table{};
  for (int i = 0; i < 1000; ++i) {
    auto& entry = table[static_cast<std::size_t>(i)];
    entry.digits[0] = static_cast<char>('0' + i / 100);
    entry.digits[1] = static_cast<char>('0' + i / 10 % 10);
    entry.digits[2] = static_cast<char>('0' + i % 10);
    entry.without_leading_zeros = i >= 100 ? 3 : i >= 10 ? 2 : 1;
  }
  return table;
}

inline constexpr auto kThreeDigits = three_digits_table();

constexpr auto thousandths_table() {
  std::array<Thousandths, 1000> table{};
  for (std::size_t i = 0; i < 1000; ++i) {
    const auto& digits = kThreeDigits[i].digits;
    table[i] = {{'.', digits[0], digits[1], digits[2]},
                i == 0         ? 0U
                : i % 100 == 0 ? 2U
                : i % 10 == 0  ? 3U
                               : 4U};
  }
  return table;
}

inline constexpr auto kThousandths = thousandths_table();

// Behind the whole part; writes four characters also where fewer count.
inline char* write_thousandths(char* out, std::uint64_t fraction) {
  const auto& entry = kThousandths[fraction];
  std::memcpy(out, entry.text, sizeof entry.text);
  return out + entry.size;
}

inline constexpr std::uint64_t kEightDigits = 100'000'000;

// The digits of a number below 10^8 in a byte each, the first one lowest: fours, then twos, then
// ones, all lanes at a time.
inline std::uint64_t eight_digits(std::uint64_t number) {
  const std::uint64_t fours = number / 10000 | number % 10000 << 32U;
  const std::uint64_t hundreds = (fours * 10486U >> 20U) & 0x0000007F0000007FU;
  const std::uint64_t twos = hundreds | (fours - hundreds * 100U) << 16U;
  const std::uint64_t tens = (twos * 103U >> 10U) & 0x000F000F000F000FU;
  return tens | (twos - tens * 10U) << 8U;
}

// Without a branch: how many digits a coordinate has, nobody can foresee.
inline char* write_below_eight_digits(char* out, std::uint64_t number) {
  constexpr std::uint64_t kLastDigit = std::uint64_t{1} << 56U;
  const std::uint64_t digits = eight_digits(number);
  const auto zeros = static_cast<unsigned>(std::countr_zero(digits | kLastDigit)) / 8U;
  const std::uint64_t text = (digits | 0x3030303030303030U) >> 8U * zeros;
  std::memcpy(out, &text, sizeof text);
  return out + 8 - zeros;
}

// So many thousandths: "-1.5". May write four characters more than count, 16 at most.
inline char* write_thousandths_of_one(char* out, std::int32_t number) {
  *out = '-';
  out += number < 0 ? 1 : 0;
  const auto magnitude =
      number < 0 ? 0U - static_cast<std::uint32_t>(number) : static_cast<std::uint32_t>(number);
  return write_thousandths(write_below_eight_digits(out, magnitude / 1000U), magnitude % 1000U);
}

}  // namespace mapwright::text
