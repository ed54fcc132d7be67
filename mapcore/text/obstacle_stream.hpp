// The obstacles of a map's text, one after another, without a map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "mapcore/map.hpp"
#include "mapcore/progress.hpp"
#include "mapcore/text/map_text.hpp"

namespace mapwright {

/// An obstacle, wherever its parts lie.
struct ObstacleView {
  std::size_t offset = 0;  ///< of its record in the text
  std::int64_t id = 0;
  ShapeType shape_type = ShapeType::kClosedPolygon;
  std::string_view semantic;          ///< lies in the text
  std::span<const Segment> segments;  ///< only until the next obstacle is read
};

/// Shown each obstacle in the order of the text; false: no more of them.
using ObstacleVisitor = std::function<bool(const ObstacleView&)>;

/// Reads a text as `read_map` does, but keeps nothing of it: memory for one obstacle at a time.
///
/// Returns the border if the text is plain: `read_map` finds no defect in it, and its map has this
/// border and the obstacles shown. Nothing where some record, or its place, or a character needs a
/// closer look, or where the visitor wanted no more; some obstacles may have been shown.
///
/// `progress` counts KiB of the text.
std::optional<Border> visit_obstacles(const MapText& text, const ObstacleVisitor& visit,
                                      const Progress& progress = {});

}  // namespace mapwright
