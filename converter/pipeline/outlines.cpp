#include "converter/pipeline/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "converter/pipeline/ring_validity.hpp"
#include "converter/pipeline/simple_solid.hpp"
#include "mapcore/angle.hpp"
#include "mapcore/geometry/hausdorff.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

// Rings of one polygon as the source has them, at the map's resolution.
struct DrawnPolygon {
  std::vector<std::vector<Point>> rings;  // the outer one first
  bool curved = false;
};

using Ring = std::vector<Point>;

// The first vertex stays the first: formats that store rings the other way round give the same map.
void reverse_ring(Ring& ring) {
  std::reverse(ring.begin() + 1, ring.end());
}

void orient(Ring& ring, RingOrientation wanted) {
  const auto found = ring_orientation(ring);
  if (found != wanted && found != RingOrientation::kDegenerate) reverse_ring(ring);
}

std::string area_text(double area_m2) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, "%.3f m2", area_m2);
  return buffer;
}

double area_m2(const SimplePolygon& polygon) {
  double area = signed_area_m2(polygon.outer);
  for (const auto& hole : polygon.holes) area += signed_area_m2(hole);
  return area;
}

// Regular polygon around a circle: no chord cuts off more than the tolerance outside of it.
Ring round_outline(Point center, double radius, const Workspace& workspace) {
  const double cosine = radius / (radius + tolerance::kChordSagitta_m);
  const int corners =
      std::max(8, static_cast<int>(std::ceil(std::numbers::pi / std::acos(cosine))));
  const double reach = radius / std::cos(std::numbers::pi / corners);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    ring.push_back(
        workspace.snapped(center + reach * unit_vector_deg(360.0 * (i + 0.5) / corners)));
  }
  return ring;
}

class PolygonCollector {
 public:
  PolygonCollector(const FeatureTask& task, Workspace& workspace)
      : task_(task), workspace_(workspace) {}

  std::vector<DrawnPolygon> collect() {
    for (const auto& path : task_.feature.geometry.paths) add(path);
    return std::move(polygons_);
  }

 private:
  void add(const SourcePath& path) {
    if (path.role == PathRole::kPoint) return add_point(path);
    CleanPath clean = clean_path(task_.feature.geometry, path, workspace_.resolution);
    const bool inner = path.role == PathRole::kInnerRing;
    if (clean.had_repeats) remark_repeats();
    if (!clean.closed && clean.points.size() > 2) {
      change_once(FindingCode::C203, "an outline that did not close was closed");
    }
    if (clean.points.size() < 3) {
      outer_is_missing_ = outer_is_missing_ || !inner;
      return change_once(FindingCode::C204, inner ? "a hole without area was left out"
                                                  : "an outline without area was left out");
    }
    if (inner && !outer_is_missing_ && !polygons_.empty()) {
      polygons_.back().rings.push_back(std::move(clean.points));
      polygons_.back().curved = polygons_.back().curved || clean.curved;
      return;
    }
    outer_is_missing_ = false;
    polygons_.push_back({{std::move(clean.points)}, clean.curved});
  }

  void add_point(const SourcePath& path) {
    if (!task_.meaning.radius_m || !(*task_.meaning.radius_m > 0.0)) {
      return change_once(FindingCode::C207, "a point has no outline, and no radius is given");
    }
    const auto& geometry = task_.feature.geometry;
    const Point center{geometry.xs[path.first], geometry.ys[path.first]};
    polygons_.push_back({{round_outline(center, *task_.meaning.radius_m, workspace_)}, true});
  }

  // The same geometry with fewer words: nothing is changed.
  void remark_repeats() {
    const std::string text = "points that stood twice in a row were taken once";
    if (said_.insert({FindingCode::C202, text}).second)
      workspace_.ledger.remark(task_.account, FindingCode::C202, text);
  }

  void change_once(FindingCode code, const std::string& message) {
    if (said_.insert({code, message}).second)
      workspace_.ledger.change(task_.account, code, message);
  }

  const FeatureTask& task_;
  Workspace& workspace_;
  std::vector<DrawnPolygon> polygons_;
  bool outer_is_missing_ = false;
  std::set<std::pair<FindingCode, std::string>> said_;
};

SimplePolygon as_drawn(DrawnPolygon& drawn) {
  SimplePolygon polygon;
  polygon.outer = std::move(drawn.rings.front());
  orient(polygon.outer, RingOrientation::kCounterClockwise);
  for (std::size_t i = 1; i < drawn.rings.size(); ++i) {
    orient(drawn.rings[i], RingOrientation::kClockwise);
    polygon.holes.push_back(std::move(drawn.rings[i]));
  }
  return polygon;
}

// Edges of rings, first vertices not repeated.
void append_edges(const std::vector<Ring>& rings, std::vector<DrawnEdge>& edges) {
  for (const auto& ring : rings) {
    const auto own = edges_of(ring, true);
    edges.insert(edges.end(), own.begin(), own.end());
  }
}

// Area of the rings as they wind, holes counting against their outlines whatever their direction.
double drawn_area_m2(const std::vector<Ring>& rings) {
  double area = std::abs(signed_area_m2(rings.front()));
  for (std::size_t i = 1; i < rings.size(); ++i) area -= std::abs(signed_area_m2(rings[i]));
  return area;
}

constexpr double kMeasureSlack_m = 1.0e-4;

Measures measures_of(const DrawnPolygon& drawn, const std::vector<SimplePolygon>& parts) {
  std::vector<DrawnEdge> before, after;
  append_edges(drawn.rings, before);
  double area = 0.0;
  for (const auto& part : parts) {
    append_edges({part.outer}, after);
    append_edges(part.holes, after);
    area += area_m2(part);
  }
  return {hausdorff_distance_m(before, after, kMeasureSlack_m), area - drawn_area_m2(drawn.rings)};
}

void say_repaired(const FeatureTask& task, const DrawnPolygon& drawn, const std::string& defect,
                  const std::vector<SimplePolygon>& parts, Workspace& workspace) {
  if (parts.empty()) {
    return workspace.ledger.change(task.account, FindingCode::C204,
                                   "an outline without area was left out (" + defect + ")");
  }
  double area = 0.0;
  std::size_t holes = 0;
  for (const auto& part : parts) {
    area += area_m2(part);
    holes += part.holes.size();
  }
  workspace.ledger.change(task.account, FindingCode::C201,
                          defect + ": cut into " + std::to_string(parts.size()) +
                              " outlines with " + std::to_string(holes) + " holes, " +
                              area_text(area) + " (odd-even rule)",
                          measures_of(drawn, parts));
}

void append_repaired(const FeatureTask& task, const DrawnPolygon& drawn, const std::string& defect,
                     Workspace& workspace, std::vector<Outline>& outlines) {
  auto parts = odd_even_polygons(drawn.rings, workspace.snap());
  if (!parts) {
    return workspace.ledger.change(task.account, FindingCode::C221,
                                   defect + ": no simple outline could be made of it");
  }
  say_repaired(task, drawn, defect, *parts, workspace);
  for (auto& part : *parts) outlines.push_back({std::move(part), drawn.curved});
}

// Each part becomes obstacles of its own, whatever it has to do with the others.
void tell_about_parts(const FeatureTask& task, const std::vector<DrawnPolygon>& polygons,
                      Workspace& workspace) {
  if (!workspace.repair || polygons.size() < 2) return;
  std::vector<std::vector<Ring>> sound;
  for (const auto& polygon : polygons) {
    if (polygon_defect(polygon.rings).empty()) sound.push_back(polygon.rings);
  }
  const auto defect = parts_defect(sound);
  if (defect.empty()) return;
  workspace.ledger.change(task.account, FindingCode::C201,
                          defect + ": each part is an obstacle of its own");
}

// Rooms are free within: the outline runs clockwise, what stands in the room counter-clockwise.
void turn_inside_out(std::vector<Outline>& outlines) {
  for (auto& outline : outlines) {
    auto& polygon = outline.polygon;
    reverse_ring(polygon.outer);
    for (auto& hole : polygon.holes) reverse_ring(hole);
  }
}

}  // namespace

std::vector<Outline> outlines_of(const FeatureTask& task, Workspace& workspace) {
  std::vector<Outline> outlines;
  auto polygons = PolygonCollector(task, workspace).collect();
  tell_about_parts(task, polygons, workspace);
  for (auto& drawn : polygons) {
    const std::string defect = workspace.repair ? polygon_defect(drawn.rings) : std::string();
    if (defect.empty())
      outlines.push_back({as_drawn(drawn), drawn.curved});
    else
      append_repaired(task, drawn, defect, workspace, outlines);
  }
  return outlines;
}

namespace {

void add_plain_outlines(const FeatureTask& task, const std::vector<Outline>& outlines,
                        double height_m, Workspace& workspace) {
  const bool ties = task.meaning.rule->kind != FeatureKind::kRoom;
  for (const auto& outline : outlines) {
    const auto type = outline.curved ? ShapeType::kClosedCurve : ShapeType::kClosedPolygon;
    add_plain(task, {outline.polygon.outer, true, type, false}, height_m, workspace);
    for (const auto& hole : outline.polygon.holes) {
      add_plain(task, {hole, true, type, ties}, height_m, workspace);
    }
  }
}

}  // namespace

void add_outlines(const FeatureTask& task, const std::vector<Outline>& outlines, double height_m,
                  Workspace& workspace) {
  if (task.is_plain) return add_plain_outlines(task, outlines, height_m, workspace);
  const SegmentStyle style{height_m, task.meaning.in_out, Semantic(task.meaning.segment_semantic)};
  for (const auto& outline : outlines) {
    const auto type = outline.curved ? ShapeType::kClosedCurve : ShapeType::kClosedPolygon;
    Draft outer = draft_for(task, type);
    outer.obstacle.segments = chain_of(outline.polygon.outer, true, style);
    const std::size_t position = workspace.drafts.size();
    workspace.drafts.push_back(std::move(outer));
    for (const auto& hole : outline.polygon.holes) {
      Draft inner = draft_for(task, type);
      if (task.meaning.rule->kind != FeatureKind::kRoom) inner.inner_of = position;
      inner.obstacle.segments = chain_of(hole, true, style);
      workspace.drafts.push_back(std::move(inner));
    }
  }
}

void add_solid(const FeatureTask& task, Workspace& workspace) {
  if (add_simple_solid(task, workspace)) return;
  auto outlines = outlines_of(task, workspace);
  if (task.meaning.rule->kind == FeatureKind::kRoom) turn_inside_out(outlines);
  if (!outlines.empty()) add_outlines(task, outlines, height_of(task, workspace), workspace);
}

}  // namespace mapwright::converter
