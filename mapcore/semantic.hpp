// Semantic strings of obstacles and segments: comma-separated labels and key=value tokens.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/shared_text.hpp"

namespace mapwright {

/// The semantic string of an obstacle or a segment (report, Eq. (2) and (3)), kept byte for byte.
///
/// A value: immutable and cheap to copy. A map repeats few strings over many segments, so copies
/// share one text.
class Semantic {
 public:
  Semantic() = default;
  Semantic(std::string_view text)  // NOLINT(google-explicit-constructor): a string is a semantic
      : text_(text) {}
  Semantic(const std::string& text) : text_(text) {}  // NOLINT
  Semantic(const char* text) : text_(text) {}         // NOLINT

  std::string_view view() const { return text_.view(); }
  std::string str() const { return std::string(view()); }
  bool empty() const { return text_.empty(); }

  /// The tokens between the commas, in order, white space around them trimmed.
  std::vector<std::string_view> tokens() const;

  /// The labels: tokens without '='.
  std::vector<std::string_view> labels() const;

  /// Value of the first token `key=value`; nothing where no token has that key.
  std::optional<std::string_view> value(std::string_view key) const;

  /// True if one of the labels is `label`.
  bool has_label(std::string_view label) const;

  /// This string with the token `key=value` set: in place where the key stands, else appended.
  /// Other tokens keep their bytes and their order.
  Semantic with_value(std::string_view key, std::string_view value) const;

  friend bool operator==(const Semantic& p, const Semantic& q) {
    return p.text_.is_shared_with(q.text_) || p.view() == q.view();
  }

 private:
  SharedText text_;
};

/// Keys with a meaning for this project (docs/format.md).
namespace semantic_key {
inline constexpr std::string_view kInnerOf = "inner_of";
inline constexpr std::string_view kNormal = "normal";
inline constexpr std::string_view kLevel = "level";
inline constexpr std::string_view kSource = "source";
inline constexpr std::string_view kName = "name";
}  // namespace semantic_key

}  // namespace mapwright
