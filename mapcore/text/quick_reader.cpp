#include "mapcore/text/quick_reader.hpp"

namespace mapwright::text {

// Only an obstacle's begins with a letter.
template <class Sink>
bool QuickReader<Sink>::read_record(const char*& at) {
  const FieldCursor cursor(at, end_);
  if (*cursor.at() == 'o') return sink_.wants_more() && read_obstacle(at);
  return read_segment(at);
}

template <class Sink>
bool QuickReader<Sink>::read_segment(const char*& at) {
  FieldCursor cursor(at, end_);
  const char* const first = cursor.at();
  Point a = last_end_.value;
  if (!cursor.same_fields(last_end_.bytes) && !cursor.point(a)) return false;
  const char* const second = cursor.at();
  Point b;
  if (!cursor.point(b)) return false;
  const char* const third = cursor.at();
  if (!cursor.same_record_end(last_.bytes)) {
    if (!read_attributes(cursor)) return false;
    last_.bytes = {third, static_cast<std::size_t>(cursor.at() - third)};
  }
  last_end_ = {{second, static_cast<std::size_t>(third - second)}, b};
  const Attributes& attributes = last_.value;
  sink_.segment(offset(first), follows_, a, b, attributes.height_m, attributes.in_out,
                attributes.semantic);
  at = cursor.at();
  return true;
}

template <class Sink>
bool QuickReader<Sink>::read_attributes(FieldCursor& cursor) {
  last_.bytes = {};
  std::string_view semantic;
  if (!cursor.number(last_.value.height_m) || !cursor.in_out(last_.value.in_out) ||
      !cursor.text(semantic) || !cursor.record_end()) {
    return false;
  }
  last_.value.semantic = sink_.semantic(semantic);
  return true;
}

template <class Sink>
bool QuickReader<Sink>::read_obstacle(const char*& at) {
  FieldCursor cursor(at, end_);
  PlainHeader header;
  header.offset = offset(cursor.at());
  std::int64_t shape_type = 0;
  if (!cursor.keyword("obstacle") || !cursor.integer(header.id)) return false;
  header.shape_type_offset = offset(cursor.at());
  if (!cursor.integer(shape_type) || !is_shape_type(shape_type)) return false;
  header.shape_type = static_cast<ShapeType>(shape_type);
  header.declared_offset = offset(cursor.at());
  if (!cursor.integer(header.declared_segments) || header.declared_segments < 0) return false;
  if (!cursor.text(header.semantic) || !cursor.record_end()) return false;
  sink_.obstacle(header);
  at = cursor.at();
  return true;
}

template <class Sink>
std::size_t QuickReader<Sink>::read(std::size_t at, std::size_t end) {
  const char* position = text_.data() + at;
  end_ = text_.data() + end;
  follows_ = false;
  while (read_record(position)) follows_ = true;
  return offset(position);
}

template <class Sink>
std::size_t QuickReader<Sink>::read_border(std::size_t at, std::size_t end, Border& border) {
  FieldCursor cursor(text_.data() + at, text_.data() + end);
  const bool is_plain = cursor.keyword("border") && cursor.number(border.left) &&
                        cursor.number(border.top) && cursor.number(border.right) &&
                        cursor.number(border.bottom) && cursor.record_end();
  return is_plain ? offset(cursor.at()) : at;
}

template class QuickReader<MapSink>;
template class QuickReader<ObstacleSink>;

}  // namespace mapwright::text
