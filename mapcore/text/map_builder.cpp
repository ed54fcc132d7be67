#include "mapcore/text/map_builder.hpp"

#include <iterator>
#include <utility>

#include "mapcore/defect_geometry.hpp"
#include "mapcore/text/characters.hpp"

namespace mapwright::text {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace

void MapBuilder::border(std::size_t offset, const std::optional<Border>& border) {
  auto& first = document_.index.border_offset;
  if (first != TextIndex::kNowhere) {
    defects_.add(FindingCode::F105, offset,
                 "a second border record; a map has one, remove the one that is wrong");
  } else {
    first = offset;
    if (state_ != State::kBeforeObstacles) {
      defects_.add(FindingCode::F106, offset,
                   "the border record stands behind obstacles; move it "
                   "to the beginning of the file");
    }
  }
  if (border && !border_is_known_) {
    document_.map.border = *border;
    border_is_known_ = true;
  }
}

void MapBuilder::obstacle(ObstacleHeader header) {
  close_obstacle();
  header_ = std::move(header);
  state_ = header_.id ? State::kInObstacle : State::kInLeftOut;
  records_ = unreadable_ = 0;
  if (!header_.id) return;
  document_.index.obstacle_offsets.push_back(header_.offset);
  reserve_declared();
}

// The exact room, unless the text is too short to hold so many.
void MapBuilder::reserve_declared() {
  if (!header_.declared_segments || *header_.declared_segments < 0) return;
  const auto declared = static_cast<std::uint64_t>(*header_.declared_segments);
  const std::size_t left = document_.text.size() - header_.offset;
  if (declared <= left / kShortestSegment) segments_.reserve(declared);
}

void MapBuilder::segment_elsewhere(std::size_t offset) {
  if (state_ != State::kBeforeObstacles) return;
  if (!first_stray_segment_) first_stray_segment_ = offset;
  ++stray_segments_;
}

void MapBuilder::unreadable_segment(std::size_t offset) {
  ++records_;
  ++unreadable_;
  segment_elsewhere(offset);
}

Subject MapBuilder::next_segment() const {
  if (state_ == State::kBeforeObstacles) return {};
  return {Subject::Kind::kSegment, header_.id, records_ + 1};
}

void MapBuilder::close_obstacle() {
  if (state_ == State::kBeforeObstacles) {
    report_stray_segments();
    return;
  }
  compare_segment_count();
  if (state_ == State::kInLeftOut) return;
  Obstacle& obstacle = document_.map.obstacles.emplace_back();
  obstacle.id = *header_.id;
  obstacle.semantic = std::move(header_.semantic);
  obstacle.segments = take_segments();
  obstacle.shape_type = shape_type();
}

// In memory of their size; where much more was set aside for them, they move.
std::vector<Segment> MapBuilder::take_segments() {
  std::vector<Segment> segments = std::exchange(segments_, {});
  if (segments.capacity() <= segments.size() + segments.size() / 8) return segments;
  return {std::make_move_iterator(segments.begin()), std::make_move_iterator(segments.end())};
}

void MapBuilder::compare_segment_count() {
  const auto declared = header_.declared_segments;
  if (!declared || static_cast<std::uint64_t>(*declared) == records_) return;
  const std::string_view text = document_.text;
  const std::string verb = records_ == 1 ? " follows" : " follow";
  defects_.add(FindingCode::F113, header_.declared_offset,
               {Subject::Kind::kObstacle, header_.id, {}},
               "declares " + counted(static_cast<std::size_t>(*declared), "segment") + " but " +
                   std::to_string(records_) + verb);
  defects_.show(geometry_of(segments_));
  // Records that could not be read may be more or fewer than they seem.
  if (unreadable_ > 0) return;
  const std::size_t begin = header_.declared_offset;
  std::size_t end = begin;
  while (end < text.size() && text[end] != ';' && text[end] != '#' && !is_blank(text[end])) ++end;
  defects_.fix(begin, end, std::to_string(records_));
}

ShapeType MapBuilder::shape_type() {
  if (header_.shape_type) return *header_.shape_type;
  const auto& segments = document_.map.obstacles.back().segments;
  const bool closes = segments.size() > 2 && segments.back().b == segments.front().a;
  const ShapeType assumed = closes ? ShapeType::kClosedPolygon : ShapeType::kOpenPolygon;
  if (!header_.unknown_shape.empty()) {
    defects_.add(FindingCode::F112, header_.shape_type_offset,
                 {Subject::Kind::kObstacle, header_.id, {}},
                 "there is no shape type " + header_.unknown_shape + ", only 1 to 6; read as " +
                     std::to_string(static_cast<int>(assumed)) +
                     (closes ? " (closed polygon)" : " (opened polygon)"));
    defects_.show(geometry_of(document_.map.obstacles.back()));
  }
  return assumed;
}

void MapBuilder::report_stray_segments() {
  if (!first_stray_segment_) return;
  defects_.add(FindingCode::F114, *first_stray_segment_,
               counted(stray_segments_, "segment") + " before the first obstacle record; left out");
}

void MapBuilder::finish(std::size_t first_record) {
  close_obstacle();
  if (document_.index.border_offset == TextIndex::kNowhere) {
    defects_.add(FindingCode::F104, first_record,
                 "there is no border record; begin the file with border;mx1;my1;mx4;my4;#");
  }
}

}  // namespace mapwright::text
