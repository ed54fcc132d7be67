// Semantic strings of exported features, with what was edited in the fields made from them.
#pragma once

#include "converter/exchange/exchange_fields.hpp"
#include "mapcore/semantic.hpp"

namespace mapwright::converter {

/// The field `semantic`, in which `kind` (its first label) and the fields of its tokens count where
/// they say something else. `altered` is set where characters had to be replaced that the map
/// format reserves.
Semantic edited_semantic(const ExchangeFields& fields, bool& altered);

/// A text from a field as a semantic string.
Semantic safe_semantic(const std::string& text, bool& altered);

}  // namespace mapwright::converter
