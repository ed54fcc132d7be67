// Semantic strings from templates and fields.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "converter/rules/field.hpp"
#include "converter/rules/rule.hpp"

namespace mapwright::converter {

/// Memory that is used again from feature to feature.
struct SemanticScratch {
  std::string value, token, piece;
  std::vector<std::uint32_t> ends;  ///< of the tokens so far
};

/// A template bound to a layer's fields.
class SemanticText {
 public:
  SemanticText() = default;
  SemanticText(const SemanticTemplate& semantic, const std::vector<std::string>& layer_fields,
               const std::string& layer_name);

  /// Puts into `text` the text for a feature: tokens with an empty field vanish, no token comes
  /// twice. Characters the map format reserves, and commas within a `key=value` token, are
  /// replaced; `altered` is set where that happened.
  void expand(const SourceFeature& feature, bool& altered, SemanticScratch& scratch,
              std::string& text) const;

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
    bool is_empty = false;  // always: it begins with a field that the layer lacks
  };

  void take_out_constants();
  static Token token_of(const std::string& part, const std::vector<std::string>& layer_fields);
  void expand_tokens(std::size_t first, std::size_t end, const SourceFeature& feature,
                     bool& altered, SemanticScratch& scratch, std::string& text) const;
  static bool fill(const Token& token, const SourceFeature& feature, bool& altered,
                   SemanticScratch& scratch);

  std::vector<Token> tokens_;
  std::size_t constants_ = 0;  // tokens at the beginning that are the same for all features
  std::string constant_text_;  // their text
  std::vector<std::uint32_t> constant_ends_;
};

}  // namespace mapwright::converter
