#include "converter/pipeline/upright_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mapwright::converter {
namespace {

// What a field or the rule's own number says counts; what stands in for a missing height does not.
double height_of(const FeatureTask& task, const UprightFace& face) {
  const auto& meaning = task.meaning;
  const bool is_said = meaning.height_m && *meaning.height_m > 0.0 && !meaning.height_is_fallback;
  return is_said ? *meaning.height_m : face.top_m - face.bottom_m;
}

SourceGeometry without(const SourceGeometry& geometry, const std::vector<UprightFace>& faces) {
  std::vector<bool> is_face(geometry.paths.size(), false);
  for (const auto& face : faces) {
    for (const auto path : face.paths) is_face[path] = true;
  }
  SourceGeometry rest = geometry;
  rest.paths.clear();
  for (std::size_t i = 0; i < geometry.paths.size(); ++i) {
    if (!is_face[i]) rest.paths.push_back(geometry.paths[i]);
  }
  return rest;
}

// Which stretches of a segment lie on edges, from 0 to 1.
class Cover {
 public:
  Cover(Point a, Point b, double reach) : a_(a), b_(b), reach_(reach) {}

  void add(Point p, Point q) {
    if (is_beside(p) && is_beside(q)) stretches_.push_back(std::minmax({place_of(p), place_of(q)}));
  }

  bool is_whole() {
    std::sort(stretches_.begin(), stretches_.end());
    const double slack = reach_ / distance(a_, b_);
    double end = 0.0;
    for (const auto& [from, to] : stretches_) {
      if (from > end + slack) return false;
      end = std::max(end, to);
    }
    return end >= 1.0 - slack;
  }

 private:
  bool is_beside(Point p) const {
    return std::abs(cross(b_ - a_, p - a_)) <= reach_ * distance(a_, b_);
  }
  double place_of(Point p) const { return dot(p - a_, b_ - a_) / squared_length(b_ - a_); }

  Point a_, b_;
  double reach_;
  std::vector<std::pair<double, double>> stretches_;
};

bool lies_on_outlines(Point a, Point b, const SourceGeometry& ground, const Workspace& workspace) {
  Cover cover(a, b, tolerance::kOverlapDepth_m);
  for (const auto& path : ground.paths) {
    const bool is_ring = path.role == PathRole::kOuterRing || path.role == PathRole::kInnerRing;
    if (!is_ring) continue;
    const auto point = [&](std::size_t i) {
      return workspace.snapped({ground.xs[path.first + i], ground.ys[path.first + i]});
    };
    for (std::size_t i = 0; i + 1 < path.count; ++i) cover.add(point(i), point(i + 1));
  }
  return cover.is_whole();
}

bool lies_on_outlines(const std::vector<Point>& line, const SourceGeometry& ground,
                      const Workspace& workspace) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (!lies_on_outlines(line[i], line[i + 1], ground, workspace)) return false;
  }
  return true;
}

void add_wall_along(const FeatureTask& task, const UprightFace& face, double height_m,
                    Workspace& workspace) {
  const auto type = face.curved ? ShapeType::kOpenCurve : ShapeType::kOpenPolygon;
  if (task.is_plain) return add_plain(task, {face.line, false, type, false}, height_m, workspace);
  Draft draft = draft_for(task, type);
  draft.obstacle.segments = chain_of(
      face.line, false, {height_m, task.meaning.in_out, Semantic(task.meaning.segment_semantic)});
  workspace.drafts.push_back(std::move(draft));
}

std::string counted(std::size_t count, const char* one, const char* several) {
  return count == 1 ? one : std::to_string(count) + several;
}

std::string metres(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g m", value);
  return buffer;
}

struct Built {
  std::size_t walls = 0, closed = 0, on_outlines = 0;
  double highest_m = 0.0;
};

void tell(const FeatureTask& task, const Built& built, Ledger& ledger) {
  if (built.walls > 0) {
    ledger.remark(task.account, FindingCode::C232,
                  counted(built.walls, "a face stands upright: a wall along its footprint",
                          " faces stand upright: walls along their footprints") +
                      ", " + (built.walls == 1 ? "" : "up to ") + metres(built.highest_m) +
                      " high");
  }
  if (built.closed > 0) {
    ledger.change(
        task.account, FindingCode::C232,
        counted(built.closed, "the openings of an upright face are closed: a wall has none",
                " upright faces have openings, which are closed: walls have none"));
  }
  if (built.on_outlines > 0) {
    ledger.remark(task.account, FindingCode::C232,
                  counted(built.on_outlines,
                          "an upright face lies on the feature's own outline and adds nothing",
                          " upright faces lie on the feature's own outlines and add nothing"));
  }
}

}  // namespace

SourceGeometry add_upright_walls(const FeatureTask& task, const std::vector<UprightFace>& faces,
                                 Workspace& workspace) {
  auto rest = without(task.feature.geometry, faces);
  Built built;
  for (const auto& face : faces) {
    if (lies_on_outlines(face.line, rest, workspace)) {
      ++built.on_outlines;
      continue;
    }
    const double height_m = height_of(task, face);
    add_wall_along(task, face, height_m, workspace);
    ++built.walls;
    built.closed += face.has_openings ? 1 : 0;
    built.highest_m = std::max(built.highest_m, height_m);
  }
  tell(task, built, workspace.ledger);
  return rest;
}

}  // namespace mapwright::converter
