// Obstacles that are a chain of points in one style, kept small: what most of a drawing is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "converter/pipeline/draft.hpp"
#include "converter/store/arena.hpp"
#include "converter/store/long_list.hpp"
#include "mapcore/grid_point.hpp"
#include "mapcore/map.hpp"
#include "mapcore/text/decimal_format.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {

/// A chain of segments that share height, side and labels. Its points and its text belong to
/// PlainObstacles.
struct PlainObstacle {
  /// Of a chain that ends where it began, the first is not repeated.
  union {
    GridPoint* grid_points = nullptr;
    Point* points;  ///< where they are not on the grid
  };
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
  bool on_grid : 1 = true;

  std::size_t segment_count() const { return joined ? count : count - 1; }
  std::string_view semantic_view() const { return {semantic, semantic_size}; }
};

/// Obstacles that follow each other and are of one kind and layer.
struct PlainRun {
  FeatureKind kind = FeatureKind::kSolid;
  std::size_t source = 0;  ///< position in Ledger::sources
  std::size_t first = 0, end = 0;
};

/// Holds an obstacle in 56 bytes, 8 for each point and its semantic string, where an Obstacle of
/// Segments takes 48 for each segment and six allocations.
class PlainObstacles {
 public:
  /// Points are kept in units of this resolution where all of a chain are such (the others as they
  /// are).
  explicit PlainObstacles(double resolution_m = tolerance::kResolution_m);

  /// What the segments of an obstacle share besides their height.
  struct Style {
    InOut in_out = InOut::kOutdoor;
    Semantic semantic;
  };

  /// Room for the points of the next obstacle; what it does not take of them is given back.
  GridPoint* room_for(std::size_t points) { return grid_points_.take(points); }
  void give_back(std::size_t points) { grid_points_.give_back(points); }
  /// Gives an obstacle points that lie elsewhere.
  void set_points(PlainObstacle& obstacle, std::span<const Point> points);

  /// Appends an obstacle whose points are set. Fills in texts and style.
  void add(PlainObstacle obstacle, FeatureKind kind, std::size_t source, std::string_view semantic,
           InOut in_out, std::string_view segment_semantic);

  LongList<PlainObstacle>& all() { return all_; }
  const LongList<PlainObstacle>& all() const { return all_; }

  /// Takes out the obstacles that are marked as gone; their memory stays.
  void remove_gone();

  /// The points of an obstacle, in `room` if need be.
  std::span<const Point> chain(const PlainObstacle& obstacle, std::vector<Point>& room) const;
  /// The same in units of the resolution; empty where they are not on the grid.
  static std::span<const GridPoint> grid_chain(const PlainObstacle& obstacle);
  /// Turns a chain round. One that ends where it began still begins at its first point.
  static void reverse(PlainObstacle& obstacle);

  double resolution_m() const { return resolution_m_; }
  std::size_t segment_count() const { return segments_; }
  /// Smallest box around all of them; kEmptyBox where there is none.
  Box extent() const;
  const std::vector<PlainRun>& runs() const { return runs_; }
  const Style& style(const PlainObstacle& obstacle) const { return styles_[obstacle.style]; }

 private:
  std::uint32_t style_of(InOut in_out, std::string_view semantic);
  void set_semantic(PlainObstacle& obstacle, std::string_view semantic);

  void append(const PlainObstacle& obstacle, FeatureKind kind, std::size_t source);
  void extend(const PlainObstacle& obstacle);

  // As Box has it; in units, four numbers at a time.
  struct GridBox {
    std::int32_t min_x = std::numeric_limits<std::int32_t>::max(), min_y = min_x;
    std::int32_t max_x = std::numeric_limits<std::int32_t>::min(), max_y = max_x;
  };

  double resolution_m_;
  text::DecimalFormat resolution_;
  Arena<GridPoint> grid_points_;
  Arena<Point> points_;
  Arena<char> texts_;
  LongList<PlainObstacle> all_;
  std::vector<PlainRun> runs_;
  std::size_t segments_ = 0;
  GridBox grid_extent_;
  Box extent_ = kEmptyBox;  // of the chains that are not on the grid
  std::vector<Style> styles_;
  std::unordered_map<std::string, std::uint32_t> known_styles_;  // by side and labels
};

/// The same as an obstacle of segments through `chain`; `semantic` stands in for its own.
Obstacle as_obstacle(const PlainObstacle& plain, std::span<const Point> chain,
                     const PlainObstacles::Style& style, const Semantic& semantic);

}  // namespace mapwright::converter
