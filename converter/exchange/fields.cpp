#include "converter/exchange/fields.hpp"

#include <algorithm>
#include <array>

namespace mapwright::converter {
namespace {

constexpr std::array<std::string_view, 6> kShapes{"closed_polygon", "open_polygon", "closed_curve",
                                                  "open_curve",     "stairs",       "ramp"};

constexpr std::size_t kLongestName = 10;

// A key that long leaves room for the number of a field its text goes on in.
constexpr std::size_t kLongestKey = kLongestName - 2;

// Names that formats use themselves.
constexpr std::array<std::string_view, 10> kTaken{"fid",  "ogc_fid", "geom",  "geometry", "layer",
                                                  "text", "type",    "shape", "ogr_geom", "wkt"};

}  // namespace

std::string_view shape_name(ShapeType type) {
  return kShapes[static_cast<std::size_t>(type) - 1];
}

std::optional<ShapeType> shape_named(std::string_view name) {
  const auto found = std::find(kShapes.begin(), kShapes.end(), name);
  if (found == kShapes.end()) return std::nullopt;
  return static_cast<ShapeType>(found - kShapes.begin() + 1);
}

bool can_be_token_field(std::string_view key) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_plain = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  if (key.empty() || key.size() > kLongestKey || !is_letter(key.front())) return false;
  if (!std::all_of(key.begin(), key.end(), is_plain)) return false;
  const bool looks_continued = key.size() > 2 && key[key.size() - 2] == '_';
  if (key == semantic_key::kInnerOf || looks_continued) return false;
  const auto& ours = exchange_field::kAll;
  return std::find(std::begin(ours), std::end(ours), key) == std::end(ours) &&
         std::find(kTaken.begin(), kTaken.end(), key) == kTaken.end();
}

std::string continued_field(const std::string& name, int number) {
  const std::string suffix = "_" + std::to_string(number);
  return name.substr(0, kLongestName - suffix.size()) + suffix;
}

}  // namespace mapwright::converter
