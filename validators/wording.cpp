#include "validators/wording.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

namespace mapwright::validators {
namespace {

std::string digits(double value, std::chars_format format, int precision) {
  std::array<char, 400> buffer;
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return {buffer.data(), result.ptr};
}

}  // namespace

std::string name_of(const Obstacle& obstacle) {
  return "obstacle " + std::to_string(obstacle.id);
}

std::string name_of(const Obstacle& obstacle, std::size_t segment) {
  return "segment " + std::to_string(segment + 1) + " of " + name_of(obstacle);
}

std::string metres(double value) {
  if (value == 0.0) return "0";
  if (std::abs(value) < 0.0005) return digits(value, std::chars_format::general, 2);
  std::string text = digits(value, std::chars_format::fixed, 3);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string place_text(Point p) {
  return "(" + metres(p.x) + ", " + metres(p.y) + ")";
}

std::string origin_text(const Finding& finding) {
  constexpr std::size_t kMost = 3;
  std::string text;
  const auto& features = finding.features;
  for (std::size_t i = 0; i < std::min(kMost, features.size()); ++i) {
    text += (i == 0 ? "from layer " : "; layer ") + features[i].layer + ", feature " +
            std::to_string(features[i].fid);
    if (!features[i].source.empty()) text += " of " + features[i].source;
  }
  if (features.size() > kMost) {
    text += "; and " + std::to_string(features.size() - kMost) + " more features";
  }
  return text;
}

std::string message_text(const Finding& finding) {
  const std::string origin = origin_text(finding);
  return origin.empty() ? finding.message : finding.message + " (" + origin + ")";
}

}  // namespace mapwright::validators
