#include "mapcore/text/quick_reader.hpp"

#include <charconv>
#include <cmath>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal.hpp"

namespace mapwright::text {

/// Walks over the fields of one record. Every function returns false where the text is not plainly
/// what it should be; the NUL behind the text is neither blank, digit, ';' nor '#'.
class QuickReader::Cursor {
 public:
  Cursor(const char* at, const char* end) : at_(at), end_(end) { skip_blanks(); }

  const char* at() const { return at_; }

  bool number(double& value) {
    const char* stop = nullptr;
    if (left() >= static_cast<std::ptrdiff_t>(kShortDecimalBytes)) {
      stop = read_short_decimal(at_, value);
    }
    if (stop == nullptr) stop = any_number(value);
    return stop != nullptr && field_end(stop);
  }

  bool integer(std::int64_t& value) {
    if (left() <= 0) return false;
    const auto [stop, error] = std::from_chars(at_, end_, value);
    return error == std::errc{} && field_end(stop);
  }

  bool in_out(InOut& value) {
    if (*at_ != '0' && *at_ != '1') return false;
    value = *at_ == '0' ? InOut::kIndoor : InOut::kOutdoor;
    return field_end(at_ + 1);
  }

  bool keyword(std::string_view word) {
    if (left() < static_cast<std::ptrdiff_t>(word.size())) return false;
    if (std::string_view(at_, word.size()) != word) return false;
    return field_end(at_ + word.size());
  }

  /// True, and the field passed, if it is exactly `expected`.
  bool same_text(std::string_view expected) {
    if (left() <= static_cast<std::ptrdiff_t>(expected.size())) return false;
    if (at_[expected.size()] != ';') return false;
    if (std::string_view(at_, expected.size()) != expected) return false;
    return field_end(at_ + expected.size());
  }

  bool text(std::string_view& value) {
    if (left() <= 0) return false;
    const char* stop = at_;
    while (stop != end_ && *stop != ';' && *stop != '#' && *stop != '\n' && *stop != '\r') ++stop;
    value = trimmed({at_, static_cast<std::size_t>(stop - at_)});
    return field_end(stop);
  }

  bool record_end() {
    if (at_ >= end_ || *at_ != '#') return false;
    ++at_;
    return true;
  }

 private:
  /// Not positive where blanks behind the end have been skipped.
  std::ptrdiff_t left() const { return end_ - at_; }

  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
  }

  bool field_end(const char* stop) {
    at_ = stop;
    if (*at_ != ';') {
      skip_blanks();
      if (at_ >= end_ || *at_ != ';') return false;
    }
    ++at_;
    skip_blanks();
    return true;
  }

  const char* any_number(double& value) {
    if (left() <= 0) return nullptr;
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || !std::isfinite(value)) return nullptr;
    value += 0.0;  // −0 becomes 0
    return stop;
  }

  const char* at_;
  const char* end_;
};

bool QuickReader::read_segment(const char*& at) {
  Cursor cursor(at, text_.data() + text_.size());
  const std::size_t first = offset(cursor.at());
  Segment segment;
  if (!cursor.number(segment.a.x) || !cursor.number(segment.a.y) || !cursor.number(segment.b.x) ||
      !cursor.number(segment.b.y) || !cursor.number(segment.height_m) ||
      !cursor.in_out(segment.in_out)) {
    return false;
  }
  if (!cursor.same_text(last_.view())) {
    std::string_view semantic;
    if (!cursor.text(semantic)) return false;
    last_ = semantics_.get(semantic);
  }
  if (!cursor.record_end()) return false;
  segment.semantic = last_;
  builder_.segment(first, std::move(segment));
  at = cursor.at();
  return true;
}

bool QuickReader::read_obstacle(const char*& at) {
  Cursor cursor(at, text_.data() + text_.size());
  ObstacleHeader header;
  header.offset = offset(cursor.at());
  std::int64_t id = 0;
  std::int64_t shape_type = 0;
  std::int64_t declared = 0;
  if (!cursor.keyword("obstacle") || !cursor.integer(id)) return false;
  header.shape_type_offset = offset(cursor.at());
  if (!cursor.integer(shape_type) || !is_shape_type(shape_type)) return false;
  header.declared_offset = offset(cursor.at());
  std::string_view semantic;
  if (!cursor.integer(declared) || declared < 0 || !cursor.text(semantic)) return false;
  if (!cursor.record_end()) return false;
  header.id = id;
  header.shape_type = static_cast<ShapeType>(shape_type);
  header.declared_segments = declared;
  header.semantic = semantics_.get(semantic);
  builder_.obstacle(std::move(header));
  at = cursor.at();
  return true;
}

std::size_t QuickReader::read(std::size_t at) {
  const char* position = text_.data() + at;
  while (read_segment(position) || read_obstacle(position)) {
  }
  return offset(position);
}

}  // namespace mapwright::text
