// Name patterns: '*' any characters, '?' one; case and accents do not count.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::converter {

/// `text` (UTF-8) in lower case and without the accents of the Latin languages: "Alçada" →
/// "alcada", "Gebäude" → "gebaude", "Straße" → "strasse". Other letters stay as they are.
std::string folded(std::string_view text);

class Pattern {
 public:
  explicit Pattern(std::string_view text) : text_(text), folded_(folded(text)) {}

  bool matches(std::string_view name) const { return matches_folded(folded(name)); }
  bool matches_folded(std::string_view name) const;
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::string folded_;
};

}  // namespace mapwright::converter
