#include "mapcore/text/decimal.hpp"

#include <charconv>
#include <cmath>

#include "mapcore/text/characters.hpp"

namespace mapwright::text {
namespace {

// A '+' is fine before a digit or a point; std::from_chars takes none.
std::string_view without_plus(std::string_view text) {
  const bool drop = text.size() > 1 && text[0] == '+' && (is_digit(text[1]) || text[1] == '.');
  return drop ? text.substr(1) : text;
}

// Decimal exponent written behind 'e', held within ±10^9.
std::int64_t written_exponent(std::string_view text) {
  const auto e = text.find_first_of("eE");
  if (e == text.npos) return 0;
  const auto [status, exponent] = read_integer(text.substr(e + 1));
  constexpr std::int64_t kLimit = 1'000'000'000;
  if (status == NumberStatus::kOk && std::abs(exponent) < kLimit) return exponent;
  return text[e + 1] == '-' ? -kLimit : kLimit;
}

// True if the magnitude of a decimal that no double holds is tiny, not huge: its first digit that
// is not 0 stands behind the point once the exponent has moved it.
bool is_tiny(std::string_view text) {
  const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
  const auto point = std::min(mantissa.find('.'), mantissa.size());
  const auto first = mantissa.find_first_of("123456789");
  const auto digits_before_point =
      static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  return digits_before_point + written_exponent(text) < 0;
}

}  // namespace

NumberReading<double> read_number(std::string_view text) {
  text = without_plus(text);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return {};
  if (error == std::errc::result_out_of_range) {
    if (is_tiny(text)) return {NumberStatus::kOk, 0.0};
    return {NumberStatus::kOutOfRange, 0.0};
  }
  if (!std::isfinite(value)) return {NumberStatus::kNonFinite, 0.0};
  return {NumberStatus::kOk, value + 0.0};
}

NumberReading<std::int64_t> read_integer(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && is_digit(text[1])) text.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return {};
  if (error == std::errc::result_out_of_range) return {NumberStatus::kOutOfRange, 0};
  return {NumberStatus::kOk, value};
}

}  // namespace mapwright::text
