#include "converter/rules/field.hpp"

#include <charconv>
#include <cmath>

#include "converter/rules/length_text.hpp"
#include "converter/rules/pattern.hpp"

namespace mapwright::converter {
namespace {

constexpr std::string_view kTagColumn = "other_tags";
constexpr std::size_t kDbfNameLength = 10;

int column_named(const std::vector<std::string>& fields, const std::string& name) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (folded(fields[i]) == name) return static_cast<int>(i);
  }
  if (name.size() <= kDbfNameLength) return -1;
  const std::string cut = name.substr(0, kDbfNameLength);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (folded(fields[i]) == cut) return static_cast<int>(i);
  }
  return -1;
}

// Value of a key in GDAL's hstore text: "key"=>"value","key2"=>"value 2".
std::optional<std::string> tag_value(std::string_view tags, const std::string& key) {
  const std::string opening = "\"" + key + "\"=>\"";
  const auto found = tags.find(opening);
  if (found == tags.npos || (found > 0 && tags[found - 1] != ',')) return std::nullopt;
  std::string value;
  for (std::size_t i = found + opening.size(); i < tags.size() && tags[i] != '"'; ++i) {
    if (tags[i] == '\\' && i + 1 < tags.size()) ++i;
    value += tags[i];
  }
  return value;
}

std::string shortest(double number) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), number);
  return {std::begin(buffer), result.ptr};
}

}  // namespace

Field::Field(const std::vector<std::string>& layer_fields, std::string_view name) {
  const std::string wanted = folded(name);
  column_ = column_named(layer_fields, wanted);
  if (column_ < 0) {
    column_ = column_named(layer_fields, std::string(kTagColumn));
    if (column_ >= 0) tag_ = name;
  }
  if (column_ >= 0) layer_name_ = layer_fields[static_cast<std::size_t>(column_)];
}

const FieldValue* Field::value(const SourceFeature& feature) const {
  const auto i = static_cast<std::size_t>(column_);
  if (column_ < 0 || i >= feature.values.size() || is_null(feature.values[i])) return nullptr;
  return &feature.values[i];
}

std::optional<std::string_view> Field::text(const SourceFeature& feature,
                                            std::string& buffer) const {
  const auto* found = value(feature);
  if (found == nullptr) return std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(found)) {
    buffer = std::to_string(*whole);
    return buffer;
  }
  if (const auto* number = std::get_if<double>(found)) {
    buffer = shortest(*number);
    return buffer;
  }
  const auto& text = std::get<std::string>(*found);
  if (!tag_.empty()) {
    auto tag = tag_value(text, tag_);
    if (!tag) return std::nullopt;
    buffer = *std::move(tag);
    return buffer;
  }
  return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
}

std::optional<std::string> Field::text(const SourceFeature& feature) const {
  std::string buffer;
  const auto found = text(feature, buffer);
  return found ? std::optional<std::string>(*found) : std::nullopt;
}

std::optional<double> Field::number(const SourceFeature& feature) const {
  const auto* found = value(feature);
  if (found == nullptr) return std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(found)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(found)) {
    return std::isfinite(*number) ? std::optional(*number) : std::nullopt;
  }
  const auto content = text(feature);
  return content ? number_from_text(*content) : std::nullopt;
}

std::optional<double> Field::length_m(const SourceFeature& feature, double metres_per_unit) const {
  const auto* found = value(feature);
  if (found == nullptr) return std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(found)) {
    return static_cast<double>(*whole) * metres_per_unit;
  }
  if (std::holds_alternative<std::string>(*found)) {
    const auto content = text(feature);
    return content ? length_from_text(*content, metres_per_unit) : std::nullopt;
  }
  const auto content = number(feature);
  return content ? std::optional(*content * metres_per_unit) : std::nullopt;
}

std::vector<Field> existing_fields(const std::vector<std::string>& layer_fields,
                                   const std::vector<std::string>& names) {
  std::vector<Field> fields;
  for (const auto& name : names) {
    if (Field field(layer_fields, name); field.exists()) fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace mapwright::converter
