// Obstacles that are a chain of points in one style, kept small: what most of a drawing is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "converter/pipeline/draft.hpp"
#include "converter/store/arena.hpp"
#include "converter/store/long_list.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

/// A chain of segments that share height, side and labels. Its points and its text belong to
/// PlainObstacles.
struct PlainObstacle {
  Point* points = nullptr;  ///< of a chain that ends where it began, the first is not repeated
  const char* semantic = nullptr;
  std::int64_t id = 0;  ///< given when the map is put together
  double height_m = 0.0;
  std::uint32_t count = 0;  ///< points
  std::uint32_t semantic_size = 0;
  std::uint32_t account = 0;  ///< in the ledger
  std::uint32_t style = 0;    ///< of the segments, but for their height
  ShapeType shape_type = ShapeType::kClosedPolygon;
  bool joined : 1 = false;    ///< the last point goes on to the first
  bool is_inner : 1 = false;  ///< a hole of the obstacle before that is none
  bool is_gone : 1 = false;   ///< not to be written

  std::span<Point> chain() const { return {points, count}; }
  std::size_t segment_count() const { return joined ? count : count - 1; }
  std::string_view semantic_view() const { return {semantic, semantic_size}; }
};

/// Obstacles that follow each other and are of one kind and layer.
struct PlainRun {
  FeatureKind kind = FeatureKind::kSolid;
  std::size_t source = 0;  ///< position in Ledger::sources
  std::size_t first = 0, end = 0;
};

/// Holds an obstacle in 56 bytes, 16 for each point and its semantic string, where an Obstacle of
/// Segments takes 64 for each segment and six allocations.
class PlainObstacles {
 public:
  /// What the segments of an obstacle share besides their height.
  struct Style {
    InOut in_out = InOut::kOutdoor;
    Semantic semantic;
  };

  /// Room for the points of the next obstacle; what it does not take of them is given back.
  Point* room_for(std::size_t points) { return points_.take(points); }
  void give_back(std::size_t points) { points_.give_back(points); }

  /// Appends an obstacle whose points lie in memory of `room_for`. Fills in texts and style.
  void add(PlainObstacle obstacle, FeatureKind kind, std::size_t source, std::string_view semantic,
           InOut in_out, std::string_view segment_semantic);

  LongList<PlainObstacle>& all() { return all_; }
  const LongList<PlainObstacle>& all() const { return all_; }

  /// Takes out the obstacles that are marked as gone; their memory stays.
  void remove_gone();

  std::size_t segment_count() const { return segments_; }
  /// Smallest box around all of them; kEmptyBox where there is none.
  const Box& extent() const { return extent_; }
  const std::vector<PlainRun>& runs() const { return runs_; }
  const Style& style(const PlainObstacle& obstacle) const { return styles_[obstacle.style]; }

 private:
  std::uint32_t style_of(InOut in_out, std::string_view semantic);
  void set_semantic(PlainObstacle& obstacle, std::string_view semantic);

  Arena<Point> points_;
  Arena<char> texts_;
  void append(const PlainObstacle& obstacle, FeatureKind kind, std::size_t source);

  LongList<PlainObstacle> all_;
  std::vector<PlainRun> runs_;
  std::size_t segments_ = 0;
  Box extent_ = kEmptyBox;
  std::vector<Style> styles_;
  std::unordered_map<std::string, std::uint32_t> known_styles_;  // by side and labels
};

/// The same as an obstacle of segments; `semantic` stands in for its own.
Obstacle as_obstacle(const PlainObstacle& plain, const PlainObstacles::Style& style,
                     const Semantic& semantic);

}  // namespace mapwright::converter
