// Private to this folder: the symbols and labels of converter/authoring/styles.
#pragma once

#include <string_view>

namespace mapwright::converter {

/// QML without a form; empty for a layer that has none.
std::string_view builtin_style(std::string_view layer);

}  // namespace mapwright::converter
