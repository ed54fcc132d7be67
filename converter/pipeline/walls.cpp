#include "converter/pipeline/walls.hpp"

#include "converter/pipeline/outlines.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

// A line at hand: of a closed one the first point is not repeated.
struct Line {
  std::vector<Point> points;
  bool closed = false;
  bool curved = false;
};

bool is_simple(const Line& line) {
  return line.closed ? is_simple_ring(line.points) : is_simple_chain(line.points);
}

void append_pieces(const FeatureTask& task, const Line& line, Workspace& workspace,
                   std::vector<Line>& lines) {
  auto points = line.points;
  if (line.closed) points.push_back(points.front());
  auto pieces = simple_chains(std::move(points), workspace.snap());
  if (!pieces) {
    return workspace.ledger.change(task.account, FindingCode::C221,
                                   "a line that crosses itself could not be cut into simple ones");
  }
  workspace.ledger.change(
      task.account, FindingCode::C201,
      "a line that crosses or touches itself was cut into " + std::to_string(pieces->size()));
  for (auto& piece : *pieces) {
    const bool closed = piece.size() > 3 && piece.front() == piece.back();
    if (closed) piece.pop_back();
    lines.push_back({std::move(piece), closed, line.curved});
  }
}

void append_line(const FeatureTask& task, const SourcePath& path, Workspace& workspace,
                 std::vector<Line>& lines) {
  CleanPath clean = clean_path(task.feature.geometry, path, workspace.resolution);
  if (clean.had_repeats) {
    workspace.ledger.remark(task.account, FindingCode::C202,
                            "points that stood twice in a row were taken once");
  }
  if (clean.points.size() < 2) {
    return workspace.ledger.change(task.account, FindingCode::C204,
                                   "a line without length was left out");
  }
  Line line{std::move(clean.points), clean.closed, clean.curved};
  if (!workspace.repair || is_simple(line)) return lines.push_back(std::move(line));
  append_pieces(task, line, workspace, lines);
}

// Also of a line that ends where it began: both of its sides are free (docs/decisions/0020).
ShapeType shape_of(const Line& line) {
  return line.curved ? ShapeType::kOpenCurve : ShapeType::kOpenPolygon;
}

std::vector<Line> lines_of(const FeatureTask& task, Workspace& workspace) {
  std::vector<Line> lines;
  for (const auto& path : task.feature.geometry.paths) {
    if (path.role == PathRole::kLine) append_line(task, path, workspace, lines);
  }
  return lines;
}

bool has_polygons(const SourceGeometry& geometry) {
  for (const auto& path : geometry.paths) {
    if (path.role == PathRole::kOuterRing) return true;
  }
  return false;
}

}  // namespace

void add_wall(const FeatureTask& task, double height_m, Workspace& workspace) {
  if (task.is_plain) {
    for (const auto& line : lines_of(task, workspace)) {
      add_plain(task, {line.points, line.closed, shape_of(line), false}, height_m, workspace);
    }
    return;
  }
  const SegmentStyle style{height_m, task.meaning.in_out, Semantic(task.meaning.segment_semantic)};
  for (const auto& line : lines_of(task, workspace)) {
    Draft draft = draft_for(task, shape_of(line));
    draft.obstacle.segments = chain_of(line.points, line.closed, style);
    workspace.drafts.push_back(std::move(draft));
  }
}

void add_wall(const FeatureTask& task, Workspace& workspace) {
  if (has_polygons(task.feature.geometry)) return add_solid(task, workspace);
  add_wall(task, height_of(task, workspace), workspace);
}

}  // namespace mapwright::converter
