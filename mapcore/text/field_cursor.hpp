// Walks over the fields of a record at speed.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "mapcore/map.hpp"
#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal.hpp"
#include "mapcore/text/short_point.hpp"

namespace mapwright::text {

namespace detail {

#if defined(__SSE2__)

inline __m128i sixteen_bytes(const char* p) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
}

#endif

/// The first ';', '#' or line break, sixteen bytes at a time as long as there are so many.
inline const char* end_of_text_field(const char* at, const char* end) {
#if defined(__SSE2__)
  for (; end - at >= 16; at += 16) {
    const __m128i bytes = sixteen_bytes(at);
    const auto equal = [&](char c) { return _mm_cmpeq_epi8(bytes, _mm_set1_epi8(c)); };
    const __m128i found =
        _mm_or_si128(_mm_or_si128(equal(';'), equal('#')), _mm_or_si128(equal('\n'), equal('\r')));
    const auto mask = static_cast<std::uint32_t>(_mm_movemask_epi8(found));
    if (mask != 0) return at + std::countr_zero(mask);
  }
#endif
  while (at != end && *at != ';' && *at != '#' && *at != '\n' && *at != '\r') ++at;
  return at;
}

/// True if `left` bytes from `at` on begin with `bytes`, no more of them, which lie before them in
/// one text.
inline bool are_equal(const char* at, std::string_view bytes, std::ptrdiff_t left) {
#if defined(__SSE2__)
  constexpr std::size_t kMost = 32;
  if (bytes.size() <= kMost && left >= static_cast<std::ptrdiff_t>(kMost)) {
    const auto differ = [&](std::size_t i) {
      const __m128i equal = _mm_cmpeq_epi8(sixteen_bytes(at + i), sixteen_bytes(bytes.data() + i));
      return static_cast<std::uint32_t>(_mm_movemask_epi8(equal)) ^ 0xFFFFU;
    };
    const std::uint32_t different = differ(0) | differ(16) << 16U;
    return (std::uint64_t{different} << (64U - bytes.size())) == 0 || bytes.empty();
  }
#endif
  return std::memcmp(at, bytes.data(), bytes.size()) == 0;
}

}  // namespace detail

/// Walks over the fields of one record. Every function returns false where the text is not plainly
/// what it should be; the NUL behind the text is neither blank, digit, ';' nor '#'.
class FieldCursor {
 public:
  FieldCursor(const char* at, const char* end) : at_(at), end_(end) { skip_blanks(); }

  const char* at() const { return at_; }

  /// True, and the fields passed, if they are written in just these bytes of the text before them,
  /// up to a ';' or blanks behind it.
  bool same_fields(std::string_view bytes) {
    if (!same_bytes(bytes)) return false;
    skip_blanks();
    return true;
  }

  /// The same for fields up to the '#' of their record.
  bool same_record_end(std::string_view bytes) { return same_bytes(bytes); }

  bool point(Point& p) {
    if (left() >= static_cast<std::ptrdiff_t>(kShortPointBytes)) {
      if (const char* const stop = read_short_point(at_, p)) {
        at_ = stop;
        skip_blanks();
        return true;
      }
    }
    return number(p.x) && number(p.y);
  }

  bool number(double& value) {
    const char* stop = nullptr;
    if (left() >= static_cast<std::ptrdiff_t>(kShortDecimalBytes)) {
      stop = read_short_decimal(at_, value);
    }
    if (stop == nullptr) stop = any_number(value);
    return stop != nullptr && field_end(stop);
  }

  bool integer(std::int64_t& value) {
    if (left() <= 0) return false;
    if (left() >= static_cast<std::ptrdiff_t>(kShortDecimalBytes)) {
      if (const char* const stop = read_short_integer(at_, value)) return field_end(stop);
    }
    const auto [stop, error] = std::from_chars(at_, end_, value);
    return error == std::errc{} && field_end(stop);
  }

  bool in_out(InOut& value) {
    if (*at_ != '0' && *at_ != '1') return false;
    value = *at_ == '0' ? InOut::kIndoor : InOut::kOutdoor;
    return field_end(at_ + 1);
  }

  template <std::size_t size>
  bool keyword(const char (&word)[size]) {
    if (left() < static_cast<std::ptrdiff_t>(size)) return false;
    if (std::memcmp(at_, word, size - 1) != 0) return false;
    return field_end(at_ + size - 1);
  }

  bool text(std::string_view& value) {
    if (left() <= 0) return false;
    const char* const stop = detail::end_of_text_field(at_, end_);
    value = trimmed({at_, static_cast<std::size_t>(stop - at_)});
    return field_end(stop);
  }

  bool record_end() {
    if (at_ >= end_ || *at_ != '#') return false;
    ++at_;
    return true;
  }

 private:
  /// Not positive where blanks behind the end have been skipped.
  std::ptrdiff_t left() const { return end_ - at_; }

  bool same_bytes(std::string_view bytes) {
    if (bytes.empty() || left() < static_cast<std::ptrdiff_t>(bytes.size())) return false;
    if (!detail::are_equal(at_, bytes, left())) return false;
    at_ += bytes.size();
    return true;
  }

  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
  }

  bool field_end(const char* stop) {
    at_ = stop;
    if (*at_ != ';') {
      skip_blanks();
      if (at_ >= end_ || *at_ != ';') return false;
    }
    ++at_;
    skip_blanks();
    return true;
  }

  const char* any_number(double& value) {
    if (left() <= 0) return nullptr;
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || !std::isfinite(value)) return nullptr;
    value += 0.0;  // −0 becomes 0
    return stop;
  }

  const char* at_;
  const char* end_;
};

}  // namespace mapwright::text
