// Writer of the map text format.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mapcore/grid_point.hpp"
#include "mapcore/map.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright {

struct WriteOptions {
  /// Coordinates and heights are rounded to multiples of this (metres, in [1e-9, 1e6]) and written
  /// with the fewest decimals that name the multiple.
  double resolution_m = tolerance::kResolution_m;
};

/// An obstacle whose segments follow each other and share all but their ends; borrowed.
struct ChainRecord {
  std::int64_t id = 0;
  ShapeType shape_type = ShapeType::kClosedPolygon;
  std::string_view semantic;
  std::span<const Point> points;           ///< at least two, or
  std::span<const GridPoint> grid_points;  ///< the same, at the resolution that is written
  bool joined = false;                     ///< the last point goes on to the first
  double height_m = 0.0;
  InOut in_out = InOut::kOutdoor;
  std::string_view segment_semantic;
};

/// Writes the canonical layout (report, appendix A; docs/format.md), obstacle by obstacle, so that
/// a map larger than memory can be written. Locale-free; never writes "-0".
///
/// Preconditions: finite numbers; no ';', '#' or line break in a semantic string
/// (`sanitized_semantic` sees to that).
class MapWriter {
 public:
  explicit MapWriter(std::ostream& out, WriteOptions options = {});
  MapWriter(const MapWriter&) = delete;
  MapWriter& operator=(const MapWriter&) = delete;
  ~MapWriter();

  void border(const Border& border);
  void obstacle(const Obstacle& obstacle);
  /// The same bytes as for the obstacle of these segments, several times as fast.
  void obstacle(const ChainRecord& chain);
  /// Hands everything to the stream. The stream's state says whether it arrived.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

void write_map(const Map& map, std::ostream& out, WriteOptions options = {});
std::string format_map(const Map& map, WriteOptions options = {});

/// The map that reading `format_map(map, options)` gives: coordinates and heights moved to the
/// nearest doubles of the decimals that are written, semantic strings without white space at their
/// ends.
Map quantized(const Map& map, WriteOptions options = {});

/// `text` with the characters the format reserves (';', '#', line breaks and other control
/// characters) replaced: by ',' for ';', by ' ' for the rest; without white space at its ends.
std::string sanitized_semantic(std::string_view text);

}  // namespace mapwright
