#include "converter/pipeline/ramps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "converter/pipeline/outlines.hpp"
#include "mapcore/angle.hpp"

namespace mapwright::converter {
namespace {

// Unit length and upwards; nothing for a null vector and for walls.
std::optional<Normal> upward_unit(Normal n) {
  const double norm = std::hypot(n.x, n.y, n.z);
  if (!std::isfinite(norm) || norm == 0.0 || std::abs(n.z) < 1e-6 * norm) return std::nullopt;
  const double scale = (n.z > 0.0 ? 1.0 : -1.0) / norm;
  return Normal{scale * n.x, scale * n.y, scale * n.z};
}

// Steepness and direction downwards, clockwise from north.
Normal normal_of_slope(double slope_deg, double aspect_deg) {
  const Point downhill = unit_vector_deg(90.0 - aspect_deg);
  const Point steepness = unit_vector_deg(slope_deg);
  return {steepness.y * downhill.x, steepness.y * downhill.y, steepness.x};
}

// From axes along the source's grid to the map's axes.
Normal turned(const Normal& n, Point north) {
  return {n.x * north.y + n.y * north.x, n.y * north.y - n.x * north.x, n.z};
}

double rise_over(const Normal& normal, const std::vector<std::vector<Point>>& footprints) {
  double rise = 0.0;
  for (const auto& footprint : footprints) {
    const RampPlane plane(normal, footprint);
    for (const Point p : footprint) rise = std::max(rise, plane.height_m(p));
  }
  return rise;
}

std::optional<Normal> given_normal(const Meaning& meaning) {
  if (meaning.normal) return upward_unit(*meaning.normal);
  if (meaning.slope_deg && meaning.aspect_deg) {
    return upward_unit(normal_of_slope(*meaning.slope_deg, *meaning.aspect_deg));
  }
  return std::nullopt;
}

std::optional<Normal> normal_from_heights(const SourceGeometry& geometry) {
  for (const auto& path : geometry.paths) {
    if (path.role == PathRole::kOuterRing) return normal_through(geometry, path);
  }
  return std::nullopt;
}

}  // namespace

// Normal equations of z = a (x − x̄) + b (y − ȳ) + c.
std::optional<Normal> normal_through(const SourceGeometry& geometry, const SourcePath& path) {
  if (geometry.zs.empty() || path.count < 3) return std::nullopt;
  double mx = 0.0, my = 0.0, mz = 0.0;
  for (std::size_t i = path.first; i < path.first + path.count; ++i) {
    mx += geometry.xs[i] / path.count;
    my += geometry.ys[i] / path.count;
    mz += geometry.zs[i] / path.count;
  }
  double xx = 0.0, xy = 0.0, yy = 0.0, xz = 0.0, yz = 0.0;
  for (std::size_t i = path.first; i < path.first + path.count; ++i) {
    const double x = geometry.xs[i] - mx, y = geometry.ys[i] - my, z = geometry.zs[i] - mz;
    xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return std::nullopt;
  const double a = (xz * yy - yz * xy) / determinant;
  const double b = (yz * xx - xz * xy) / determinant;
  return upward_unit({-a, -b, 1.0});
}

namespace {

bool is_drawn_as_line(const SourceGeometry& geometry) {
  return std::any_of(geometry.paths.begin(), geometry.paths.end(),
                     [](const SourcePath& path) { return path.role == PathRole::kLine; });
}

std::string missing_for_line(const Meaning& meaning) {
  if (!meaning.slope_deg || *meaning.slope_deg == 0.0) return "how steep it is";
  if (!meaning.upwards) return "which end is up";
  if (!meaning.width_m || !(*meaning.width_m > 0.0)) return "how wide it is";
  return {};
}

// Rectangle around a straight piece, counter-clockwise.
std::vector<Point> strip(Point from, Point to, double width_m, const Workspace& workspace) {
  const Point along = (1.0 / distance(from, to)) * (to - from);
  const Point left = (0.5 * width_m) * Point{-along.y, along.x};
  std::vector<Point> corners{from - left, to - left, to + left, from + left};
  for (Point& p : corners) p = workspace.snapped(p);
  return corners;
}

}  // namespace

// Each straight piece of the line is a ramp of its own: a bend turns the slope.
void RampCollector::add_along_lines(const FeatureTask& task) {
  const auto missing = missing_for_line(task.meaning);
  if (!missing.empty()) {
    return workspace_.ledger.drop(task.account, FindingCode::C218,
                                  "a ramp drawn as a line of which nothing says " + missing);
  }
  const double slope_deg = std::abs(*task.meaning.slope_deg);
  for (const auto& path : task.feature.geometry.paths) {
    const auto line = clean_path(task.feature.geometry, path, workspace_.resolution).points;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      Ramp ramp;
      ramp.draft = draft_for(task, ShapeType::kRamp);
      ramp.style = {0.0, task.meaning.in_out, Semantic(task.meaning.segment_semantic)};
      ramp.account = task.account;
      ramp.refers_to_map = true;
      const Point up = *task.meaning.upwards ? line[i + 1] - line[i] : line[i] - line[i + 1];
      const Point steepness = unit_vector_deg(slope_deg);
      const Point downhill = (-steepness.y / length(up)) * up;
      ramp.normal = upward_unit({downhill.x, downhill.y, steepness.x});
      ramp.footprints.push_back(strip(line[i], line[i + 1], *task.meaning.width_m, workspace_));
      ramps_.push_back(std::move(ramp));
    }
  }
}

void RampCollector::add(const FeatureTask& task) {
  if (is_drawn_as_line(task.feature.geometry)) return add_along_lines(task);
  Ramp ramp;
  ramp.draft = draft_for(task, ShapeType::kRamp);
  ramp.style = {0.0, task.meaning.in_out, Semantic(task.meaning.segment_semantic)};
  ramp.axes = task.meaning.rule->axes;
  ramp.rise_m = task.meaning.rise_m;
  ramp.grid_north = task.grid_north;
  ramp.account = task.account;
  ramp.normal = given_normal(task.meaning);
  if (!ramp.normal) {
    ramp.normal = normal_from_heights(task.feature.geometry);
    ramp.refers_to_map = true;
  } else if (!task.meaning.normal) {
    ramp.axes = NormalAxes::kSource;  // an aspect counts from the grid's north
  }
  if (!ramp.normal) {
    return workspace_.ledger.drop(task.account, FindingCode::C218,
                                  "nothing says how the ramp slopes: give nx, ny, nz, or slope and "
                                  "aspect, or heights of its vertices");
  }
  for (auto& outline : outlines_of(task, workspace_)) {
    if (!outline.polygon.holes.empty()) {
      workspace_.ledger.change(task.account, FindingCode::C223,
                               "a hole in the footprint was left out");
    }
    ramp.footprints.push_back(std::move(outline.polygon.outer));
  }
  if (!ramp.footprints.empty()) ramps_.push_back(std::move(ramp));
}

// The frame in which the planes rise by what the features say they do.
bool RampCollector::normals_refer_to_map(std::string& grounds) const {
  double off_in_map = 0.0;
  double off_in_source = 0.0;
  int witnesses = 0;
  for (const auto& ramp : ramps_) {
    if (!ramp.rise_m || ramp.refers_to_map || ramp.axes != NormalAxes::kAuto) continue;
    off_in_map += std::abs(rise_over(*ramp.normal, ramp.footprints) - *ramp.rise_m);
    off_in_source +=
        std::abs(rise_over(turned(*ramp.normal, ramp.grid_north), ramp.footprints) - *ramp.rise_m);
    ++witnesses;
  }
  if (witnesses == 0 || !(off_in_map < 0.5 * off_in_source)) return false;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "normals were taken in the map's axes: %d ramps then rise as they say within %.3f m on "
      "average, in the grid's axes within %.3f m",
      witnesses, off_in_map / witnesses, off_in_source / witnesses);
  grounds = text;
  return true;
}

void RampCollector::write(Ramp& ramp, bool auto_means_map, const std::string& grounds) {
  const bool by_evidence = !ramp.refers_to_map && ramp.axes == NormalAxes::kAuto && auto_means_map;
  const bool map_axes = ramp.refers_to_map || ramp.axes == NormalAxes::kMap || by_evidence;
  const Normal normal = map_axes ? *ramp.normal : turned(*ramp.normal, ramp.grid_north);
  if (by_evidence) workspace_.ledger.remark(ramp.account, FindingCode::C225, grounds);
  ramp.draft.obstacle.semantic =
      ramp.draft.obstacle.semantic.with_value(semantic_key::kNormal, format_normal(normal));
  for (const auto& footprint : ramp.footprints) {
    Draft draft = ramp.draft;
    draft.obstacle.segments = chain_of(footprint, true, ramp.style);
    workspace_.drafts.push_back(std::move(draft));
  }
}

void RampCollector::finish() {
  std::string grounds;
  const bool auto_means_map = normals_refer_to_map(grounds);
  for (auto& ramp : ramps_) write(ramp, auto_means_map, grounds);
  ramps_.clear();
}

}  // namespace mapwright::converter
