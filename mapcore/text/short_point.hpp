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

  /// Exact: eight digits fit a double, and one division rounds once.
  double value(const char* p) const {
    const std::uint64_t before = load_digits(p + first) << 8U * (8U - whole()) >> 8U * decimals();
    const std::uint64_t behind = load_digits(p + point + 1) << 8U * (8U - decimals());
    const auto digits = static_cast<std::int64_t>(digits_value(before | behind, 8));
    const double magnitude = static_cast<double>(digits) / kDoublePowersOfTen[decimals()];
    const std::uint64_t sign = std::uint64_t{minus} << 63U;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) ^ sign) + 0.0;  // no −0
  }
};

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
  value = {x.value(p), y.value(p)};
  return p + y.end + 1;
}

#else

inline const char* read_short_point(const char* /*p*/, Point& /*value*/) {
  return nullptr;
}

#endif

}  // namespace mapwright::text
