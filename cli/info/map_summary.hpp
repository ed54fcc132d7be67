// What `info` tells about a map.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/geometry/bounding_circle.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright::cli {

inline constexpr int kShapeTypes = 6;

/// What the report states for its own map: 30 KB for about 10,000 m² (section 5).
inline constexpr double kReportBytesPerM2 = 3.0;

/// Order statistics of some lengths; percentiles by nearest rank. Zeros for none.
struct Spread {
  double min = 0.0, median = 0.0, mean = 0.0, p95 = 0.0, max = 0.0;
};

Spread spread_of(std::vector<double> values);

struct ShapeCount {
  std::size_t obstacles = 0;
  std::size_t segments = 0;
};

struct ObstacleCircle {
  std::int64_t obstacle = 0;  ///< id
  Circle circle;
};

struct MapSummary {
  std::size_t bytes = 0;  ///< of the text
  std::size_t obstacles = 0;
  std::size_t segments = 0;
  std::array<ShapeCount, kShapeTypes> by_shape_type{};  ///< [ST − 1]
  std::size_t indoor = 0, outdoor = 0;                  ///< segments
  double length_m = 0.0;                                ///< of all segments
  Border border;
  Box extent = kEmptyBox;
  Spread heights_m;              ///< of segments
  std::size_t zero_heights = 0;  ///< segments of height 0
  Spread segments_per_obstacle;
  Spread circle_radii_m;  ///< minimum bounding circles of obstacles with segments
  std::optional<ObstacleCircle> largest_circle;
  std::size_t distinct_semantics = 0;
  std::array<std::size_t, 3> findings{};  ///< [severity]

  /// Size of the text over the border's area; nothing for a border without area.
  std::optional<double> bytes_per_m2() const;
};

MapSummary summarize(const MapDocument& document);

}  // namespace mapwright::cli
