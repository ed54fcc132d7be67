// Private to this folder: obstacles clipped at a box.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright {

/// Clips obstacles of one map, as `crop` promises. Borrows the map. The pieces of a family depend
/// on nothing but the family, the box and the resolution, except for the ids beyond the map's
/// greatest.
class Cutter {
 public:
  Cutter(const Map& map, const Box& box, double resolution_m);

  /// Appends what is left of an outline and its holes (positions in the map), or of a single
  /// obstacle; returns how many obstacles were altered. The first piece carries a CutRecord.
  std::size_t cut(std::span<const std::size_t> family, std::vector<Obstacle>& part);

 private:
  using Ring = std::vector<Point>;

  bool is_solid(std::span<const std::size_t> family) const;
  const Obstacle* untouched_hole(const Ring& ring, std::span<const std::size_t> family) const;
  void append_hole(const Ring& ring, const std::string& outline_id,
                   std::span<const std::size_t> family, std::vector<Obstacle>& part);
  void cut_solid(std::span<const std::size_t> family, std::vector<Obstacle>& part);
  void cut_chain(const Obstacle& obstacle, std::vector<Obstacle>& part);
  void leave_record(std::span<const Obstacle* const> family, Obstacle& piece) const;
  Obstacle outline_of(const Ring& ring, const Obstacle& like,
                      std::span<const std::size_t> family) const;
  Segment edge_of(Point a, Point b, std::span<const std::size_t> family) const;
  Ring clipped(const Ring& ring) const;
  Point snapped(Point p) const { return {format_.rounded(p.x), format_.rounded(p.y)}; }

  const Map& map_;
  Box box_;
  text::DecimalFormat format_;
  double resolution_m_;
  std::int64_t last_id_ = 0;
};

}  // namespace mapwright
