// Ramps: footprints with a surface normal.
#pragma once

#include <optional>
#include <vector>

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Ramps of one layer. What their normals refer to can be found out only from all of them together
/// (docs/rules.md, `axes: auto`), so they wait until the layer is read.
class RampCollector {
 public:
  explicit RampCollector(Workspace& workspace) : workspace_(workspace) {}

  void add(const FeatureTask& task);
  void finish();

 private:
  struct Ramp {
    Draft draft;  // without segments and normal
    std::vector<std::vector<Point>> footprints;
    SegmentStyle style;
    std::optional<Normal> normal;  // as given: of the source's grid or of the map
    bool refers_to_map = false;    // computed from Z: no doubt about its axes
    NormalAxes axes = NormalAxes::kAuto;
    std::optional<double> rise_m;
    Point grid_north;
    std::size_t account = 0;
  };

  void add_along_lines(const FeatureTask& task);
  bool normals_refer_to_map(std::string& grounds) const;
  void write(Ramp& ramp, bool auto_means_map, const std::string& grounds);

  Workspace& workspace_;
  std::vector<Ramp> ramps_;
};

/// Least-squares plane through the vertices of a ring with heights: its upward unit normal. Nothing
/// where the vertices lie on a line or heights are missing.
std::optional<Normal> normal_through(const SourceGeometry& geometry, const SourcePath& path);

}  // namespace mapwright::converter
