// What a drawing tells about the units and axes of its coordinates.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converter/source/feature.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

/// Sizes are in the drawing's own units.
struct DrawingEvidence {
  Box extent = kEmptyBox;
  std::optional<double> edge;          ///< median length of straight edges
  std::size_t measured_edges = 0;      ///< straight ones of the length of walls
  std::size_t round_edges = 0;         ///< of them multiples of 0.05, to 0.002
  std::optional<double> tread;         ///< median distance of neighbouring step lines
  std::optional<double> door;          ///< median length of doors
  std::size_t corners = 0;             ///< looked at
  std::size_t right_as_drawn = 0;      ///< right angles among them, as plain x and y
  std::size_t right_as_degrees = 0;    ///< as longitude and latitude
  std::size_t right_if_exchanged = 0;  ///< as latitude and longitude
};

/// Looks at features of layers whose CRS nobody states. Steps and doors are known by the names of
/// their layers, in the languages of the built-in rules. Keeps a bounded sample.
class EvidenceCollector {
 public:
  void add(const std::string& layer, const SourceGeometry& geometry);
  DrawingEvidence evidence() const;

 private:
  void classify(const std::string& layer);
  void add_edges(const SourceGeometry& geometry, const SourcePath& path);
  void add_corners(const SourceGeometry& geometry, const SourcePath& path);

  DrawingEvidence found_;
  std::optional<std::string> layer_;  // the one that was asked about last
  bool is_steps_ = false, is_doors_ = false;
  std::vector<double> edges_, doors_;
  std::vector<std::pair<Point, Point>> steps_;  // from end to end
};

/// True if the angle at `corner` is right within 1.5 degrees, coordinates scaled before.
bool is_right_angle(Point before, Point corner, Point after, double x_scale, double y_scale);

}  // namespace mapwright::converter
