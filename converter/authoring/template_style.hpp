// The QGIS style of a template's layer: how it looks, and the form its features are edited with.
#pragma once

#include <string>

#include "converter/authoring/template_layers.hpp"

namespace mapwright::converter {

/// QML as QGIS 3.22 and later read it from the table layer_styles: symbols and labels drawn for
/// this project, and a form made from the layer's fields: value lists, ranges, labels, defaults.
std::string template_style(const TemplateLayer& layer);

}  // namespace mapwright::converter
