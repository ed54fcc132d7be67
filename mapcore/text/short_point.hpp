// Reading the two coordinates of a point at once.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "mapcore/point.hpp"
#include "mapcore/text/decimal.hpp"

namespace mapwright::text {

/// Bytes that `read_short_point` may look at.
inline constexpr std::size_t kShortPointBytes = 40;

#if defined(__SSE2__)

namespace detail {

/// Of 32 bytes a bit each: set where they hold no digit.
inline std::uint32_t other_than_digits(const char* p) {
  const auto mask = [](const char* at) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
    const __m128i value = _mm_sub_epi8(bytes, _mm_set1_epi8('0'));
    const __m128i is_digit = _mm_cmpeq_epi8(_mm_min_epu8(value, _mm_set1_epi8(9)), value);
    return static_cast<std::uint32_t>(_mm_movemask_epi8(is_digit));
  };
  return ~(mask(p) | mask(p + 16) << 16U);
}

/// "-21198.865;": where its parts lie, by their distance from where the text was looked at.
struct ShortDecimal {
  unsigned minus = 0;  ///< 1 with a minus sign
  unsigned first = 0;  ///< digit
  unsigned point = 0;
  unsigned end = 0;  ///< the ';'

  unsigned whole() const { return point - first; }
  unsigned decimals() const { return end - point - 1; }

  /// True if it has one digit before the point, one behind it, and no more than eight in all.
  bool is_plain(const char* p) const {
    return p[point] == '.' && p[end] == ';' && point > first && end > point + 1 && end - first <= 9;
  }

  /// Its digits, the point left out, in eight bytes: zeros, then the values of the digits.
  std::uint64_t digits(const char* p) const {
    const std::uint64_t before = load_digits(p + first) << 8U * (8U - whole()) >> 8U * decimals();
    const std::uint64_t behind = load_digits(p + point + 1) << 8U * (8U - decimals());
    return before | behind;
  }

  std::uint64_t sign() const { return std::uint64_t{minus} << 63U; }
};

/// Both values at once, by neighbours: digits to pairs, pairs to fours, fours to numbers. Exact:
/// eight digits fit a double, and one division rounds once.
[[gnu::always_inline]] inline void read_values(const char* p, const ShortDecimal& x,
                                               const ShortDecimal& y, Point& value) {
  const auto two = [](std::uint64_t low, std::uint64_t high) {
    return _mm_set_epi64x(static_cast<std::int64_t>(high), static_cast<std::int64_t>(low));
  };
  const __m128i digits = two(x.digits(p), y.digits(p));
  const __m128i tens =
      _mm_mullo_epi16(_mm_and_si128(digits, _mm_set1_epi16(0xFF)), _mm_set1_epi16(10));
  const __m128i pairs = _mm_add_epi16(tens, _mm_srli_epi16(digits, 8));
  const __m128i fours = _mm_madd_epi16(pairs, _mm_set1_epi32(1 << 16 | 100));
  const __m128i packed = _mm_packs_epi32(fours, fours);
  const __m128i numbers = _mm_madd_epi16(packed, _mm_set1_epi32(1 << 16 | 10000));
  const __m128d scales =
      _mm_set_pd(kDoublePowersOfTen[y.decimals()], kDoublePowersOfTen[x.decimals()]);
  const __m128d magnitudes = _mm_div_pd(_mm_cvtepi32_pd(numbers), scales);
  const __m128d signs = _mm_castsi128_pd(two(x.sign(), y.sign()));
  // −0 becomes 0.
  _mm_storeu_pd(&value.x, _mm_add_pd(_mm_xor_pd(magnitudes, signs), _mm_setzero_pd()));
}

/// Takes the number that begins at `begin` off the places that hold no digit. They must be enough.
inline ShortDecimal take_decimal(const char* p, unsigned begin, std::uint32_t& others) {
  ShortDecimal number;
  number.minus = p[begin] == '-' ? 1 : 0;
  number.first = begin + number.minus;
  others &= ~(number.minus << begin);
  number.point = static_cast<unsigned>(std::countr_zero(others));
  others &= others - 1;
  number.end = static_cast<unsigned>(std::countr_zero(others));
  others &= others - 1;
  return number;
}

}  // namespace detail

/// Reads "X;Y;", each a decimal of two to eight digits with a point between them. Returns the end,
/// or nullptr where the text has another shape. At least kShortPointBytes must be readable.
///
/// Where the fields end is found for both at once: one after the other, each would wait for the
/// one before.
inline const char* read_short_point(const char* p, Point& value) {
  // Bits for places beyond these end a search that finds too few.
  constexpr std::uint32_t kBeyond = 0xFF000000U;
  std::uint32_t others = detail::other_than_digits(p) | kBeyond;
  const auto x = detail::take_decimal(p, 0, others);
  if (!x.is_plain(p)) return nullptr;
  const auto y = detail::take_decimal(p, x.end + 1, others);
  if (!y.is_plain(p)) return nullptr;
  detail::read_values(p, x, y, value);
  return p + y.end + 1;
}

#else

inline const char* read_short_point(const char* /*p*/, Point& /*value*/) {
  return nullptr;
}

#endif

}  // namespace mapwright::text
