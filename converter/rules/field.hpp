// Fields of a layer, found by the names rules use.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// A field of one layer. Names are compared without case and accents; the ten characters that a
/// shapefile keeps of a longer name count as the name. Where a layer has no such field but OSM's
/// `other_tags`, the tag of that name stands for it.
class Field {
 public:
  Field() = default;
  Field(const std::vector<std::string>& layer_fields, std::string_view name);

  bool exists() const { return column_ >= 0; }
  /// Name as the layer spells it; empty where it does not exist.
  const std::string& layer_name() const { return layer_name_; }

  /// The value as text; nothing where it is null or empty. Numbers in their shortest form.
  std::optional<std::string> text(const SourceFeature& feature) const;

  /// The same in memory that is used again: the text is the feature's own, or in `buffer`.
  std::optional<std::string_view> text(const SourceFeature& feature, std::string& buffer) const;

  /// The value as a number, where it is one, or a text that is one.
  std::optional<double> number(const SourceFeature& feature) const;

  /// The value as a length in metres (texts may carry their unit).
  std::optional<double> length_m(const SourceFeature& feature, double metres_per_unit) const;

  /// True if there is a value, of whatever kind.
  bool has_value(const SourceFeature& feature) const { return text(feature).has_value(); }

 private:
  const FieldValue* value(const SourceFeature& feature) const;

  int column_ = -1;
  std::string tag_;  // key within other_tags; empty: the column itself
  std::string layer_name_;
};

/// The fields that exist, in the order of `names`.
std::vector<Field> existing_fields(const std::vector<std::string>& layer_fields,
                                   const std::vector<std::string>& names);

}  // namespace mapwright::converter
