// Semantic strings from templates and fields.
#pragma once

#include <string>
#include <vector>

#include "converter/rules/field.hpp"
#include "converter/rules/rule.hpp"

namespace mapwright::converter {

/// A template bound to a layer's fields.
class SemanticText {
 public:
  SemanticText() = default;
  SemanticText(const SemanticTemplate& semantic, const std::vector<std::string>& layer_fields,
               const std::string& layer_name);

  /// The text for a feature: tokens with an empty field vanish, no token comes twice. Characters
  /// the map format reserves, and commas within a `key=value` token, are replaced; `altered` is set
  /// where that happened.
  std::string expand(const SourceFeature& feature, bool& altered) const;

  /// Layer fields the template reads.
  std::vector<std::string> fields() const;

 private:
  struct Piece {
    std::string literal;  // before the field
    Field field;
    bool has_field = false;
  };
  struct Token {
    std::vector<Piece> pieces;
    bool is_key_value = false;
  };
  std::vector<Token> tokens_;
};

}  // namespace mapwright::converter
