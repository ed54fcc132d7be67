// Walks over the fields of a record at speed.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "mapcore/map.hpp"
#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal.hpp"

namespace mapwright::text {

namespace detail {

// 0x80 in each byte of the word that is `wanted`, and maybe in bytes above one that is.
inline std::uint64_t bytes_equal(std::uint64_t word, unsigned char wanted) {
  constexpr std::uint64_t kOnes = 0x0101010101010101U;
  const std::uint64_t difference = word ^ (kOnes * wanted);
  return (difference - kOnes) & ~difference & 0x8080808080808080U;
}

// The first ';', '#' or line break, eight bytes at a time as long as there are so many.
inline const char* end_of_text_field(const char* at, const char* end) {
  for (; end - at >= 8; at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, sizeof word);
    const std::uint64_t found = bytes_equal(word, ';') | bytes_equal(word, '#') |
                                bytes_equal(word, '\n') | bytes_equal(word, '\r');
    if (found != 0) break;
  }
  while (at != end && *at != ';' && *at != '#' && *at != '\n' && *at != '\r') ++at;
  return at;
}

}  // namespace detail

/// Walks over the fields of one record. Every function returns false where the text is not plainly
/// what it should be; the NUL behind the text is neither blank, digit, ';' nor '#'.
class FieldCursor {
 public:
  FieldCursor(const char* at, const char* end) : at_(at), end_(end) { skip_blanks(); }

  const char* at() const { return at_; }

  /// True, and the fields passed, if they are written in just these bytes, up to a ';' or blanks
  /// behind it.
  bool same_fields(std::string_view bytes) {
    if (!same_bytes(bytes)) return false;
    skip_blanks();
    return true;
  }

  /// The same for fields up to the '#' of their record.
  bool same_record_end(std::string_view bytes) { return same_bytes(bytes); }

  bool point(Point& p) { return number(p.x) && number(p.y); }

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

  bool keyword(std::string_view word) {
    if (left() < static_cast<std::ptrdiff_t>(word.size())) return false;
    if (std::string_view(at_, word.size()) != word) return false;
    return field_end(at_ + word.size());
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
    if (std::memcmp(at_, bytes.data(), bytes.size()) != 0) return false;
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
