#include "mapcore/text/quick_reader.hpp"

namespace mapwright::text {
namespace {

// Bytes that read_joined_segment may look at, whatever stands there.
constexpr std::ptrdiff_t kRoomForSegment = 160;

// There, and so short that they, two line breaks and a short point between them take no more.
bool are_short(std::string_view point, std::string_view attributes) {
  return point.size() - 1U < 32U && attributes.size() - 1U < 80U;
}

}  // namespace

// Only an obstacle's begins with a letter.
template <class Sink>
bool QuickReader<Sink>::read_record(const char*& at) {
  if (*at == '\n' ? read_joined_segment<1>(at) : read_joined_segment<0>(at)) return true;
  const FieldCursor cursor(at, end_);
  if (*cursor.at() == 'o') return sink_.wants_more() && read_obstacle(at);
  return read_segment(at);
}

// As most segments are: from the end of the one before it, as high as that one, a line for each
// point or no lines at all, and long before the end of what is to be read. Others are left to
// read_segment. How many line breaks there are is not added up: where to read on would wait for it.
template <class Sink>
template <int kLineBreaks>
bool QuickReader<Sink>::read_joined_segment(const char*& at) {
  if (end_ - at < kRoomForSegment || !are_short(last_end_.bytes, last_.bytes)) return false;
  const char* const first = at + kLineBreaks;
  if (!detail::are_equal(first, last_end_.bytes, kRoomForSegment)) return false;
  const char* const second = first + last_end_.bytes.size();
  Point b;
  const char* const stop = read_short_point(second, b);
  if (stop == nullptr) return false;
  if ((*stop == '\n' ? 1 : 0) != kLineBreaks) return false;
  const char* const third = stop + kLineBreaks;
  if (!detail::are_equal(third, last_.bytes, kRoomForSegment)) return false;
  add_segment(first, last_end_.value, b);
  last_end_.bytes = {second, static_cast<std::size_t>(third - second)};
  last_end_.value = b;
  at = third + last_.bytes.size();
  return true;
}

template <class Sink>
void QuickReader<Sink>::add_segment(const char* first, const Point& a, const Point& b) {
  sink_.segment(offset(first), follows_, a, b, last_.value.height_m, last_.value.in_out,
                last_.value.semantic);
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
  last_end_.bytes = {second, static_cast<std::size_t>(third - second)};
  last_end_.value = b;
  add_segment(first, a, b);
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
  PlainHeader& header = sink_.next_header();
  header.offset = offset(cursor.at());
  std::int64_t shape_type = 0;
  if (!cursor.keyword("obstacle") || !cursor.integer(header.id)) return false;
  header.shape_type_offset = offset(cursor.at());
  if (!cursor.integer(shape_type) || !is_shape_type(shape_type)) return false;
  header.shape_type = static_cast<ShapeType>(shape_type);
  header.declared_offset = offset(cursor.at());
  if (!cursor.integer(header.declared_segments) || header.declared_segments < 0) return false;
  if (!cursor.text(header.semantic) || !cursor.record_end()) return false;
  sink_.obstacle();
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
