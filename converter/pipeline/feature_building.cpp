// What LayerConverter makes of a feature that has its place and its meaning.
#include "converter/pipeline/layer_converter.hpp"
#include "converter/pipeline/outlines.hpp"
#include "converter/pipeline/upright_walls.hpp"
#include "converter/pipeline/walls.hpp"

namespace mapwright::converter {
namespace {

bool may_stand_upright(FeatureKind kind) {
  return kind == FeatureKind::kSolid || kind == FeatureKind::kRoom || kind == FeatureKind::kWall;
}

}  // namespace

void LayerConverter::build_with_upright_faces(const FeatureTask& task,
                                              const std::vector<UprightFace>& faces) {
  SourceFeature rest = task.feature;
  rest.geometry = add_upright_walls(task, faces, workspace_);
  if (rest.geometry.paths.empty()) return;
  build({rest, task.meaning, task.account, task.source, task.grid_north, task.is_plain});
}

void LayerConverter::build(const FeatureTask& task) {
  if (may_stand_upright(task.meaning.rule->kind)) {
    const auto faces =
        upright_faces(task.feature.geometry, options_.resolution_m, workspace_.snap());
    if (!faces.empty()) return build_with_upright_faces(task, faces);
  }
  switch (task.meaning.rule->kind) {
    case FeatureKind::kObstacle:
      exchange_.load(task.feature);
      return exported_.add(task, exchange_, job_.place);
    case FeatureKind::kSolid:
    case FeatureKind::kRoom:
      return add_solid(task, workspace_);
    case FeatureKind::kWall:
      return add_wall(task, workspace_);
    case FeatureKind::kRamp:
      return ramps_.add(task);
    case FeatureKind::kStairs:
      return stairs_.add_stairs(task, job_.place);
    case FeatureKind::kSteps:
      if (!task.meaning.stair_id.empty()) return stairs_.add_step(task, job_.place);
      workspace_.ledger.remark(task.account, FindingCode::C217,
                               "a step without stair id: written as a low wall");
      return add_wall(task, task.meaning.rise_m.value_or(workspace_.settings.rise_m), workspace_);
    case FeatureKind::kBorder: {
      const Box box = extent_of(task.feature.geometry);
      workspace_.border.add({box.min_x, box.min_y});
      workspace_.border.add({box.max_x, box.max_y});
      return workspace_.ledger.remark(task.account, FindingCode::C227,
                                      "its extent is the map's border");
    }
    case FeatureKind::kIgnore:
      return;
  }
}

}  // namespace mapwright::converter
