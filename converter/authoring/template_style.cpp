#include "converter/authoring/template_style.hpp"

#include <cassert>
#include <charconv>
#include <pugixml.hpp>
#include <sstream>

#include "converter/authoring/builtin_styles.hpp"

namespace mapwright::converter {
namespace {

// QgsFieldConstraints: of which kind a constraint is, and how strong.
constexpr int kByExpression = 4;
constexpr int kHard = 1;

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// QGIS keeps values of any kind in trees of <Option>.
pugi::xml_node add_option(pugi::xml_node parent, const char* type, std::string_view name = {}) {
  auto option = parent.append_child("Option");
  option.append_attribute("type") = type;
  if (!name.empty()) option.append_attribute("name") = std::string(name).c_str();
  return option;
}

void add_value(pugi::xml_node parent, const char* type, std::string_view name,
               std::string_view value) {
  add_option(parent, type, name).append_attribute("value") = std::string(value).c_str();
}

void add_value_list(pugi::xml_node config, const FieldDomain& domain) {
  auto list = add_option(add_option(config, "Map"), "List", "map");
  for (const auto& listed : domain.values) {
    add_value(add_option(list, "Map"), "QString", listed.label, listed.value);
  }
}

void add_range(pugi::xml_node config, const FieldDomain& domain) {
  auto options = add_option(config, "Map");
  add_value(options, "bool", "AllowNull", "true");
  add_value(options, "double", "Min", number(domain.least));
  add_value(options, "double", "Max", number(domain.most));
  const bool whole = domain.type == FieldType::kInteger;
  add_value(options, "double", "Step", whole ? "1" : "0.1");
  add_value(options, "int", "Precision", whole ? "0" : "3");
  add_value(options, "QString", "Style", "SpinBox");
}

void add_widget(pugi::xml_node fields, const TemplateField& field) {
  auto entry = fields.append_child("field");
  entry.append_attribute("name") = std::string(field.name).c_str();
  entry.append_attribute("configurationFlags") = "None";
  auto widget = entry.append_child("editWidget");
  const bool lists = field.domain != nullptr && !field.domain->values.empty();
  widget.append_attribute("type") = lists                     ? "ValueMap"
                                    : field.domain != nullptr ? "Range"
                                                              : "TextEdit";
  auto config = widget.append_child("config");
  if (lists)
    add_value_list(config, *field.domain);
  else if (field.domain != nullptr)
    add_range(config, *field.domain);
}

std::string quoted(std::string_view name) {
  return '"' + std::string(name) + '"';
}

// An expression of QGIS that is true for what the domain allows.
std::string allowed(const TemplateField& field) {
  const auto& domain = *field.domain;
  const std::string name = quoted(field.name);
  if (domain.values.empty()) {
    return name + " IS NULL OR (" + name + " >= " + number(domain.least) + " AND " + name +
           " <= " + number(domain.most) + ")";
  }
  std::string list;
  for (const auto& listed : domain.values) {
    const std::string value = domain.type == FieldType::kText
                                  ? "'" + std::string(listed.value) + "'"
                                  : std::string(listed.value);
    list += (list.empty() ? "" : ", ") + value;
  }
  return name + " IS NULL OR " + name + " IN (" + list + ")";
}

void add_form(pugi::xml_node qgis, const TemplateLayer& layer) {
  auto widgets = qgis.append_child("fieldConfiguration");
  auto aliases = qgis.append_child("aliases");
  auto defaults = qgis.append_child("defaults");
  auto strengths = qgis.append_child("constraints");
  auto constraints = qgis.append_child("constraintExpressions");
  int index = 1;  // 0 is the feature id
  for (const auto& field : layer.fields) {
    const std::string name(field.name);
    add_widget(widgets, field);
    auto alias = aliases.append_child("alias");
    alias.append_attribute("field") = name.c_str();
    alias.append_attribute("index") = index++;
    alias.append_attribute("name") = std::string(field.label).c_str();
    if (!field.initial.empty()) {
      auto initial = defaults.append_child("default");
      initial.append_attribute("field") = name.c_str();
      initial.append_attribute("applyOnUpdate") = "0";
      initial.append_attribute("expression") =
          (field.type == FieldType::kText ? "'" + std::string(field.initial) + "'"
                                          : std::string(field.initial))
              .c_str();
    }
    if (field.domain == nullptr) continue;
    auto strength = strengths.append_child("constraint");
    strength.append_attribute("field") = name.c_str();
    strength.append_attribute("constraints") = kByExpression;
    strength.append_attribute("exp_strength") = kHard;
    auto constraint = constraints.append_child("constraint");
    constraint.append_attribute("field") = name.c_str();
    constraint.append_attribute("exp") = allowed(field).c_str();
    constraint.append_attribute("desc") = std::string(field.domain->description).c_str();
  }
}

}  // namespace

std::string template_style(const TemplateLayer& layer) {
  pugi::xml_document document;
  const std::string_view symbols = builtin_style(layer.name);
  const auto parsed = document.load_buffer(symbols.data(), symbols.size(),
                                           pugi::parse_default | pugi::parse_doctype);
  assert(parsed);
  (void)parsed;
  add_form(document.child("qgis"), layer);
  std::ostringstream text;
  document.save(text, " ", pugi::format_indent | pugi::format_no_declaration);
  return text.str();
}

}  // namespace mapwright::converter
