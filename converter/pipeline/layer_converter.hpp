// Converts the features of one layer.
#pragma once

#include "converter/pipeline/axis_suspicion.hpp"
#include "converter/pipeline/exported_obstacles.hpp"
#include "converter/pipeline/ramps.hpp"
#include "converter/pipeline/sources.hpp"
#include "converter/pipeline/stairs.hpp"
#include "converter/pipeline/upright_faces.hpp"
#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

class LayerConverter {
 public:
  /// Borrows everything else; `source` is the layer's position in the ledger.
  LayerConverter(const ConvertOptions& options, const LayerJob& job, MapTransform transform,
                 std::size_t source, Workspace& workspace, StairsCollector& stairs,
                 ExportedObstacles& exported);

  /// Reads the layer to its end. Fails where it cannot be read, or its coordinates cannot be what
  /// its CRS says.
  Result<void> run();

 private:
  void convert(SourceFeature& feature);
  void convert_parts(const SourceFeature& feature, std::size_t account);
  void convert_part(SourceFeature& feature, std::size_t account);
  bool is_plain() const;
  bool is_exported_obstacle(const SourceFeature& feature);
  bool selects(const SourceFeature& feature, std::size_t account);
  bool would_build(const SourceFeature& feature);
  bool fits_building(const SourceFeature& feature);
  bool interprets(const SourceFeature& feature, std::size_t account);
  void place_exactly(std::span<double> xs, std::span<double> ys);
  void place(SourceGeometry& geometry);
  bool places_nearby(SourceGeometry& geometry);
  bool places(SourceFeature& feature, std::size_t account);
  bool keeps(const SourceFeature& feature, std::size_t account);
  void tell_about_values(const SourceFeature& feature, std::size_t account);
  void build(const FeatureTask& task);
  void build_with_upright_faces(const FeatureTask& task, const std::vector<UprightFace>& faces);
  void take_heights_in_metres(SourceGeometry& geometry) const;
  bool check_degrees(const SourceFeature& feature);

  const ConvertOptions& options_;
  const LayerJob& job_;
  MapTransform transform_;
  std::size_t source_;
  Workspace& workspace_;
  StairsCollector& stairs_;
  ExportedObstacles& exported_;
  ExchangeFields exchange_;
  RampCollector ramps_;
  LayerRules rules_;
  std::string layer_label_;
  AxisSuspicion suspicion_;
  Meaning meaning_;
  Point grid_north_{0.0, 1.0};
  std::optional<Failure> failure_;
  std::size_t done_ = 0;
};

}  // namespace mapwright::converter
