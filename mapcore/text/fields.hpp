// The fields of a record, one after another.
#pragma once

#include <cstddef>
#include <string_view>

#include "mapcore/text/characters.hpp"

namespace mapwright::text {

/// The text up to a ';', or up to the record's end where there is none.
struct Field {
  std::string_view text;   ///< without white space at its ends
  std::size_t offset = 0;  ///< of `text`; of the ';' or the record's end where it is empty
  std::size_t next = 0;    ///< offset behind the ';', or of the record's end
  bool closed = false;     ///< by a ';'
};

/// The field that begins at `at` in a record that ends at `end`.
inline Field field_at(std::string_view text, std::size_t at, std::size_t end) {
  const auto raw = text.substr(at, end - at);
  const auto semicolon = raw.find(';');
  const bool closed = semicolon != raw.npos;
  const auto content = trimmed(raw.substr(0, semicolon));
  return {content, static_cast<std::size_t>(content.data() - text.data()),
          closed ? at + semicolon + 1 : end, closed};
}

/// Walks over the fields of a record, `at` to `end`.
class FieldWalker {
 public:
  FieldWalker(std::string_view text, std::size_t at, std::size_t end)
      : text_(text), at_(at), end_(end) {}

  Field next() {
    const Field field = field_at(text_, at_, end_);
    at_ = field.next;
    return field;
  }
  std::size_t at() const { return at_; }
  bool done() const { return at_ >= end_; }

 private:
  std::string_view text_;
  std::size_t at_;
  std::size_t end_;
};

}  // namespace mapwright::text
