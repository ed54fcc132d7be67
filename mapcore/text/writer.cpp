#include "mapcore/text/writer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstring>
#include <ostream>
#include <sstream>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal_format.hpp"
#include "mapcore/text/point_texts.hpp"
#include "mapcore/text/segment_tails.hpp"

namespace mapwright {
namespace {

using text::DecimalFormat;
using text::PointTexts;
using text::SegmentTail;
using text::SegmentTails;

[[maybe_unused]] bool is_writable(std::string_view semantic) {
  return semantic.find_first_of(";#\n\r") == semantic.npos;
}

/// Gathers text and hands it to a stream in large pieces: of what is written at once, a file system
/// may keep many pages as one.
class Block {
 public:
  explicit Block(std::ostream& out) : out_(out), bytes_(new char[kBytes]), at_(bytes_.get()) {}

  /// Where up to `bytes` may be written; `advance_to` tells how many were.
  char* room_for(std::size_t bytes) {
    if (bytes > static_cast<std::size_t>(bytes_.get() + kBytes - at_)) flush();
    return at_;
  }
  void advance_to(char* end) { at_ = end; }

  void flush() {
    out_.write(bytes_.get(), at_ - bytes_.get());
    at_ = bytes_.get();
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
  static constexpr std::size_t kBytes = std::size_t{1} << 18U;
  std::ostream& out_;
  std::unique_ptr<char[]> bytes_;  // not set: a small map touches a few pages of it
  char* at_;
};

char* put(char* at, char c) {
  *at = c;
  return at + 1;
}

char* put(char* at, std::string_view text) {
  return at + text.copy(at, text.size());  // also of nothing, which lies nowhere
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

  void semantic_and_end(std::string_view semantic) {
    assert(is_writable(semantic));
    block.text(text::trimmed(semantic));
    block.text(kEnd);
  }

  void header(std::int64_t id, ShapeType type, std::size_t segments, std::string_view semantic) {
    char* at = put(block.room_for(kHeaderBytes), "obstacle;\n");
    for (const std::int64_t number :
         {id, static_cast<std::int64_t>(type), static_cast<std::int64_t>(segments)}) {
      at = put(std::to_chars(at, at + kIntegerBytes, number).ptr, ';');
    }
    const auto labels = text::trimmed(semantic);
    if (labels.size() > kShortLabels) {
      block.advance_to(at);
      return semantic_and_end(labels);
    }
    assert(is_writable(labels));
    block.advance_to(put(put(at, labels), kEnd));
  }

  void segment(const Segment& segment) {
    char* at = block.room_for(3 * kPointBytes);
    at = put_point(put_point(at, segment.a), segment.b);
    at = put(numbers.write(at, segment.height_m), ';');
    at = put(put(at, segment.in_out == InOut::kIndoor ? '0' : '1'), ';');
    block.advance_to(at);
    semantic_and_end(segment.semantic.view());
  }

  // Each point is made text once and stands in two segments.
  void chain(const ChainRecord& chain) {
    const bool on_grid = !chain.grid_points.empty();
    const std::size_t last = (on_grid ? chain.grid_points.size() : chain.points.size()) - 1;
    header(chain.id, chain.shape_type, chain.joined ? last + 1 : last, chain.semantic);
    assert(is_writable(chain.segment_semantic));
    tail = &tails.of(chain.height_m, chain.in_out, chain.segment_semantic, numbers);
    on_grid ? link_all(chain.grid_points, chain.joined) : link_all(chain.points, chain.joined);
  }

  void link_all(std::span<const Point> points, bool joined) {
    set_text(first, points[0]);
    const PointText* here = &first;
    for (std::size_t i = 1; i < points.size(); ++i) {
      PointText& next = others[i % 2];
      set_text(next, points[i]);
      link(*here, next);
      here = &next;
    }
    if (joined) link(*here, first);
  }

  void link_all(std::span<const GridPoint> points, bool joined) {
    if (points.size() > PointTexts::kMost) return link_pieces(points, joined);
    texts.set(points, numbers);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) link(i, i + 1);
    if (joined) link(points.size() - 1, 0);
  }

  void link_pieces(std::span<const GridPoint> points, bool joined) {
    for (std::size_t i = 0; i + 1 < points.size(); i += PointTexts::kMost - 1) {
      link_all(points.subspan(i, std::min(PointTexts::kMost, points.size() - i)), false);
    }
    if (!joined) return;
    const std::array<GridPoint, 2> ends{points.back(), points.front()};
    link_all(ends, false);
  }

  static constexpr std::size_t kIntegerBytes = 20;
  static constexpr std::string_view kEnd = ";\n#\n";
  static constexpr std::size_t kShortLabels = 1024;
  static constexpr std::size_t kHeaderBytes = 3 * (kIntegerBytes + 1) + kShortLabels + 16;
  static constexpr std::size_t kPointBytes = 2 * (DecimalFormat::kMaxCharacters + 2);

  struct PointText {
    std::array<char, kPointBytes> bytes;
    std::size_t size = 0;

    void append_to(char*& at) const {
      constexpr std::size_t kUsual = 48;  // a length the compiler knows: a few moves, no call
      if (size <= kUsual)
        std::memcpy(at, bytes.data(), kUsual);
      else
        std::memcpy(at, bytes.data(), size);
      at += size;
    }
  };

  void set_text(PointText& text, Point p) const {
    text.size = static_cast<std::size_t>(put_point(text.bytes.data(), p) - text.bytes.data());
  }

  void link(const PointText& a, const PointText& b) {
    char* at = block.room_for(3 * kPointBytes);
    a.append_to(at);
    b.append_to(at);
    append_tail(at);
  }

  void link(std::size_t a, std::size_t b) {
    char* at = block.room_for(2 * PointTexts::kBytes + kPointBytes);
    texts.append(a, at);
    texts.append(b, at);
    append_tail(at);
  }

  void append_tail(char* at) {
    if (tail->is_short()) tail->append_to(at);
    block.advance_to(at);
    if (!tail->is_short()) block.text(tail->text);
  }

  Block block;
  DecimalFormat numbers;
  PointTexts texts;
  PointText first;
  std::array<PointText, 2> others;
  SegmentTails tails;
  const SegmentTail* tail = nullptr;  // of the chain under way
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
  impl_->header(obstacle.id, obstacle.shape_type, obstacle.segments.size(),
                obstacle.semantic.view());
  for (const auto& segment : obstacle.segments) impl_->segment(segment);
}

void MapWriter::obstacle(const ChainRecord& chain) {
  impl_->chain(chain);
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
