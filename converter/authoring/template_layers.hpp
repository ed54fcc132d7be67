// What an authoring template holds: layers, fields, value lists.
#pragma once

#include <span>
#include <string_view>

namespace mapwright::converter {

enum class FieldType { kText, kReal, kInteger };

/// One of the values that a field may have, and what a form shows for it.
struct ListedValue {
  std::string_view value, label;
};

/// What a field may hold: values of a list, or numbers within limits.
struct FieldDomain {
  std::string_view name;
  std::string_view description;
  FieldType type = FieldType::kText;
  std::span<const ListedValue> values;  ///< empty: numbers from least to most
  double least = 0.0, most = 0.0;
};

struct TemplateField {
  std::string_view name;   ///< as the rules `mapwright` read it (docs/rules.md)
  std::string_view label;  ///< what a form calls it, with the unit
  FieldType type = FieldType::kText;
  const FieldDomain* domain = nullptr;
  std::string_view initial = {};  ///< default value, as text; empty: none
};

enum class TemplateGeometry { kPolygon, kLine };

struct TemplateLayer {
  std::string_view name;
  std::string_view description;  ///< one sentence: what is drawn here, and how
  TemplateGeometry geometry = TemplateGeometry::kPolygon;
  std::span<const TemplateField> fields;
};

/// In the order in which an editor is to stack them, the lowest first. The first is the border.
std::span<const TemplateLayer> template_layers();

/// Every domain that a field names, once.
std::span<const FieldDomain* const> template_domains();

}  // namespace mapwright::converter
