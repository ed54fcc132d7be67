#include "converter/rules/length_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

namespace mapwright::converter {
namespace {

constexpr double kFoot_m = 0.3048;
constexpr double kInch_m = 0.0254;

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 14> kUnits{{{"m", 1.0},
                                       {"meter", 1.0},
                                       {"meters", 1.0},
                                       {"metre", 1.0},
                                       {"metres", 1.0},
                                       {"metros", 1.0},
                                       {"cm", 0.01},
                                       {"mm", 0.001},
                                       {"ft", kFoot_m},
                                       {"feet", kFoot_m},
                                       {"foot", kFoot_m},
                                       {"'", kFoot_m},
                                       {"\"", kInch_m},
                                       {"in", kInch_m}}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '~')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// Takes a number from the front of `text`. One comma is a decimal point if no point follows.
std::optional<double> take_number(std::string_view& text) {
  std::string digits(text.substr(0, text.find_first_not_of("0123456789.,+-eE")));
  if (digits.find('.') == digits.npos && std::count(digits.begin(), digits.end(), ',') == 1) {
    std::replace(digits.begin(), digits.end(), ',', '.');
  }
  const char* begin = digits.data() + (digits.starts_with('+') ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, digits.data() + digits.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - digits.data()));
  text = trimmed(text);
  return value;
}

std::optional<double> unit_named(std::string_view name) {
  for (const auto& unit : kUnits) {
    if (unit.name == name) return unit.metres;
  }
  return std::nullopt;
}

// 12'6" and 12'
std::optional<double> feet_and_inches(std::string_view text) {
  const auto feet = take_number(text);
  if (!feet || !text.starts_with('\'')) return std::nullopt;
  text = trimmed(text.substr(1));
  if (text.empty()) return *feet * kFoot_m;
  const auto inches = take_number(text);
  if (!inches || text != "\"") return std::nullopt;
  return *feet * kFoot_m + *inches * kInch_m;
}

}  // namespace

std::optional<double> length_from_text(std::string_view text, double metres_per_unit) {
  text = trimmed(text);
  if (const auto length = feet_and_inches(text)) return length;
  const auto value = take_number(text);
  if (!value) return std::nullopt;
  if (text.empty()) return *value * metres_per_unit;
  const auto unit = unit_named(text);
  if (!unit) return std::nullopt;
  return *value * *unit;
}

std::optional<double> number_from_text(std::string_view text) {
  text = trimmed(text);
  const auto value = take_number(text);
  return value && text.empty() ? value : std::nullopt;
}

std::optional<double> slope_deg_from_text(std::string_view text) {
  text = trimmed(text);
  const auto value = take_number(text);
  if (!value) return std::nullopt;
  if (text == "%") return std::atan(*value / 100.0) * 180.0 / std::numbers::pi;
  return text.empty() || text == "\u00b0" ? value : std::nullopt;
}

}  // namespace mapwright::converter
