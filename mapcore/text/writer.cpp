#include "mapcore/text/writer.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <ostream>
#include <sstream>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright {
namespace {

using text::DecimalFormat;

[[maybe_unused]] bool is_writable(std::string_view semantic) {
  return semantic.find_first_of(";#\n\r") == semantic.npos;
}

/// Gathers text and hands it to a stream in large pieces.
class Block {
 public:
  explicit Block(std::ostream& out) : out_(out), bytes_(kBytes), at_(bytes_.data()) {}

  /// Where up to `bytes` may be written; `advance_to` tells how many were.
  char* room_for(std::size_t bytes) {
    if (bytes > static_cast<std::size_t>(bytes_.data() + kBytes - at_)) flush();
    return at_;
  }
  void advance_to(char* end) { at_ = end; }

  void flush() {
    out_.write(bytes_.data(), at_ - bytes_.data());
    at_ = bytes_.data();
  }

  /// Text of any length.
  void text(std::string_view text) {
    if (text.size() > kBytes) {
      flush();
      out_.write(text.data(), static_cast<std::streamsize>(text.size()));
      return;
    }
    advance_to(std::copy(text.begin(), text.end(), room_for(text.size())));
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 16U;
  std::ostream& out_;
  std::vector<char> bytes_;
  char* at_;
};

char* put(char* at, char c) {
  *at = c;
  return at + 1;
}

}  // namespace

struct MapWriter::Impl {
  Impl(std::ostream& out, WriteOptions options) : block(out), numbers(options.resolution_m) {}

  // x;y;⏎
  char* put_point(char* at, Point p) const {
    at = put(numbers.write(at, p.x), ';');
    return put(put(numbers.write(at, p.y), ';'), '\n');
  }

  void point(Point p) { block.advance_to(put_point(block.room_for(kPointBytes), p)); }

  void semantic_and_end(const Semantic& semantic) {
    assert(is_writable(semantic.view()));
    block.text(text::trimmed(semantic.view()));
    block.text(";\n#\n");
  }

  void header(const Obstacle& obstacle) {
    block.text("obstacle;\n");
    char* at = block.room_for(kHeaderBytes);
    for (const std::int64_t number : {obstacle.id, static_cast<std::int64_t>(obstacle.shape_type),
                                      static_cast<std::int64_t>(obstacle.segments.size())}) {
      at = put(std::to_chars(at, at + kIntegerBytes, number).ptr, ';');
    }
    block.advance_to(at);
    semantic_and_end(obstacle.semantic);
  }

  void segment(const Segment& segment) {
    char* at = block.room_for(3 * kPointBytes);
    at = put_point(put_point(at, segment.a), segment.b);
    at = put(numbers.write(at, segment.height_m), ';');
    at = put(put(at, segment.in_out == InOut::kIndoor ? '0' : '1'), ';');
    block.advance_to(at);
    semantic_and_end(segment.semantic);
  }

  static constexpr std::size_t kIntegerBytes = 20;
  static constexpr std::size_t kHeaderBytes = 3 * (kIntegerBytes + 1);
  static constexpr std::size_t kPointBytes = 2 * (DecimalFormat::kMaxCharacters + 2);

  Block block;
  DecimalFormat numbers;
};

MapWriter::MapWriter(std::ostream& out, WriteOptions options)
    : impl_(std::make_unique<Impl>(out, options)) {}

MapWriter::~MapWriter() = default;

void MapWriter::border(const Border& border) {
  impl_->block.text("border;\n");
  impl_->point({border.left, border.top});
  impl_->point({border.right, border.bottom});
  impl_->block.text("#\n");
}

void MapWriter::obstacle(const Obstacle& obstacle) {
  impl_->header(obstacle);
  for (const auto& segment : obstacle.segments) impl_->segment(segment);
}

void MapWriter::finish() {
  impl_->block.flush();
}

void write_map(const Map& map, std::ostream& out, WriteOptions options) {
  MapWriter writer(out, options);
  writer.border(map.border);
  for (const auto& obstacle : map.obstacles) writer.obstacle(obstacle);
  writer.finish();
}

std::string format_map(const Map& map, WriteOptions options) {
  std::ostringstream out;
  write_map(map, out, options);
  return std::move(out).str();
}

namespace {

Semantic trimmed(const Semantic& semantic) {
  const auto text = text::trimmed(semantic.view());
  return text.size() == semantic.view().size() ? semantic : Semantic(text);
}

Segment quantized(const Segment& segment, const DecimalFormat& numbers) {
  Segment result = segment;
  for (double* value : {&result.a.x, &result.a.y, &result.b.x, &result.b.y, &result.height_m}) {
    *value = numbers.rounded(*value);
  }
  result.semantic = trimmed(segment.semantic);
  return result;
}

}  // namespace

Map quantized(const Map& map, WriteOptions options) {
  const DecimalFormat numbers(options.resolution_m);
  Map result;
  result.border = {numbers.rounded(map.border.left), numbers.rounded(map.border.top),
                   numbers.rounded(map.border.right), numbers.rounded(map.border.bottom)};
  result.obstacles.reserve(map.obstacles.size());
  for (const auto& obstacle : map.obstacles) {
    Obstacle copy{obstacle.id, obstacle.shape_type, trimmed(obstacle.semantic), {}};
    copy.segments.reserve(obstacle.segments.size());
    for (const auto& segment : obstacle.segments) {
      copy.segments.push_back(quantized(segment, numbers));
    }
    result.obstacles.push_back(std::move(copy));
  }
  return result;
}

std::string sanitized_semantic(std::string_view text) {
  std::string clean(text);
  for (char& c : clean) {
    if (c == ';') c = ',';
    if (c == '#' || text::is_control(c) || text::is_blank(c)) c = ' ';
  }
  return std::string(text::trimmed(clean));
}

}  // namespace mapwright
