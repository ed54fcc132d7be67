// Reads the fields of exported features, however a format keeps them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converter/rules/field.hpp"
#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// Fields of one layer: as columns, whose long texts may go on in further columns, or within a
/// column of text (DXF's RawCodeValues). Values of the feature that was loaded
/// last.
class ExchangeFields {
 public:
  explicit ExchangeFields(std::vector<std::string> layer_fields);

  void load(const SourceFeature& feature);

  /// True if the layer, or the text that carries fields, has it.
  bool has(std::string_view name) const;
  /// Nothing where the feature has no value.
  std::optional<std::string> text(std::string_view name) const;
  std::optional<double> number(std::string_view name) const;
  std::optional<std::int64_t> integer(std::string_view name) const;

 private:
  const std::vector<Field>& columns(std::string_view name) const;

  std::vector<std::string> layer_fields_;
  std::vector<Field> carriers_;
  mutable std::map<std::string, std::vector<Field>, std::less<>> columns_;
  const SourceFeature* feature_ = nullptr;
  std::optional<std::map<std::string, std::string, std::less<>>> carried_;
};

/// A number in a text; nothing where there is more to it.
std::optional<double> exact_number(std::string_view text);
std::optional<std::int64_t> exact_integer(std::string_view text);

}  // namespace mapwright::converter
