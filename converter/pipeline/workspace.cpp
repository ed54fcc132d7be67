#include "converter/pipeline/workspace.hpp"

#include <charconv>
#include <iterator>

namespace mapwright::converter {
namespace {

std::string metres(double value) {
  char buffer[32];
  const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value).ptr;
  return std::string(std::begin(buffer), end) + " m";
}

}  // namespace

double height_of(const FeatureTask& task, Workspace& workspace) {
  const auto& height = task.meaning.height_m;
  if (height && *height > 0.0) return *height;
  const double fallback = workspace.settings.default_height_m;
  if (height) {
    workspace.ledger.change(
        task.account, FindingCode::C216,
        "height " + metres(*height) + " is none: " + metres(fallback) + " stands in");
  } else {
    workspace.ledger.remark(task.account, FindingCode::C216,
                            "no height is given: " + metres(fallback) + " stands in");
  }
  return fallback;
}

Draft draft_for(const FeatureTask& task, ShapeType shape_type) {
  Draft draft;
  draft.obstacle.shape_type = shape_type;
  draft.obstacle.semantic = Semantic(task.meaning.semantic);
  draft.kind = task.meaning.rule->kind;
  draft.source = task.source;
  draft.features.push_back(task.account);
  return draft;
}

void finish_plain(const FeatureTask& task, PlainObstacle plain, double height_m,
                  Workspace& workspace) {
  const auto& meaning = task.meaning;
  plain.height_m = height_m;
  plain.account = static_cast<std::uint32_t>(task.account);
  workspace.plain.add(plain, meaning.rule->kind, task.source, meaning.semantic, meaning.in_out,
                      meaning.segment_semantic);
}

void add_plain(const FeatureTask& task, const PlainShape& shape, double height_m,
               Workspace& workspace) {
  PlainObstacle plain;
  workspace.plain.set_points(plain, shape.points);
  plain.shape_type = shape.type;
  plain.joined = shape.joined;
  plain.is_inner = shape.is_inner;
  finish_plain(task, plain, height_m, workspace);
}

}  // namespace mapwright::converter
