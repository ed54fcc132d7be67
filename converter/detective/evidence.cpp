#include "converter/detective/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "converter/rules/pattern.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kMostEdges = 20000;
constexpr std::size_t kMostSteps = 2000;
constexpr double kLeastWall = 0.5, kLongestWall = 100.0;
constexpr double kRoundStep = 0.05, kRoundSlack = 0.002;
constexpr double kRightAngleSlack = 0.026;  // cosine; 1.5°

const std::vector<std::string> kStepNames{"*step*",   "*stair*", "*escal*",  "*esglao*", "*grao*",
                                          "*treppe*", "*stufe*", "*marche*", "*scal*"};
const std::vector<std::string> kDoorNames{"*door*", "*porta*", "*puerta*",
                                          "*tuer*", "*tur*",   "*porte*"};

bool fits_one(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return Pattern(pattern).matches(name); });
}

double cosine_deg(double degrees) {
  return std::cos(degrees * (std::numbers::pi / 180.0));
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

using Line = std::pair<Point, Point>;

// From the middle of a line straight to a parallel one beside it; infinite where it is not beside.
double distance_to_parallel(const Line& from, const Line& to) {
  constexpr double kParallel = 0.1;  // sine; 6 degrees
  const Point u = from.second - from.first, v = to.second - to.first;
  const double lengths = length(u) * length(v);
  if (!(lengths > 0.0) || std::abs(cross(u, v)) > kParallel * lengths) return HUGE_VAL;
  const Point offset = 0.5 * (from.first + from.second) - to.first;
  const double along = dot(offset, v) / dot(v, v);
  const double away = std::abs(cross(v, offset)) / length(v);
  return along < 0.0 || along > 1.0 || away == 0.0 ? HUGE_VAL : away;
}

// Each to the one next to it. All pairs: the sample is small.
std::vector<double> nearest_distances(const std::vector<Line>& lines) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    double nearest = HUGE_VAL;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (i != j) nearest = std::min(nearest, distance_to_parallel(lines[i], lines[j]));
    }
    if (std::isfinite(nearest)) distances.push_back(nearest);
  }
  return distances;
}

}  // namespace

bool is_right_angle(Point before, Point corner, Point after, double x_scale, double y_scale) {
  const Point in{x_scale * (corner.x - before.x), y_scale * (corner.y - before.y)};
  const Point out{x_scale * (after.x - corner.x), y_scale * (after.y - corner.y)};
  const double lengths = length(in) * length(out);
  return lengths > 0.0 && std::abs(dot(in, out)) < kRightAngleSlack * lengths;
}

void EvidenceCollector::classify(const std::string& layer) {
  if (layer_ == layer) return;
  layer_ = layer;
  is_steps_ = fits_one(kStepNames, layer);
  is_doors_ = fits_one(kDoorNames, layer);
}

void EvidenceCollector::add(const std::string& layer, const SourceGeometry& geometry) {
  classify(layer);
  for (std::size_t i = 0; i < geometry.xs.size(); ++i) {
    if (std::isfinite(geometry.xs[i]) && std::isfinite(geometry.ys[i]))
      found_.extent.add({geometry.xs[i], geometry.ys[i]});
  }
  for (const auto& path : geometry.paths) {
    if (path.count < 2 || path.curved) continue;
    const std::size_t last = path.first + path.count - 1;
    const Point a{geometry.xs[path.first], geometry.ys[path.first]};
    const Point b{geometry.xs[last], geometry.ys[last]};
    const bool is_line = path.role == PathRole::kLine;
    if (is_line && is_steps_ && steps_.size() < kMostSteps)
      steps_.emplace_back(a, b);
    else if (is_line && is_doors_)
      doors_.push_back(distance(a, b));
    else
      add_edges(geometry, path);
    add_corners(geometry, path);
  }
}

void EvidenceCollector::add_edges(const SourceGeometry& geometry, const SourcePath& path) {
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
    if (edges_.size() >= kMostEdges) return;
    const double edge =
        std::hypot(geometry.xs[i] - geometry.xs[i - 1], geometry.ys[i] - geometry.ys[i - 1]);
    edges_.push_back(edge);
    if (edge < kLeastWall || edge > kLongestWall) continue;
    ++found_.measured_edges;
    found_.round_edges += std::abs(std::remainder(edge, kRoundStep)) < kRoundSlack;
  }
}

void EvidenceCollector::add_corners(const SourceGeometry& geometry, const SourcePath& path) {
  const auto point = [&](std::size_t j) { return Point{geometry.xs[j], geometry.ys[j]}; };
  for (std::size_t i = path.first + 1; i + 1 < path.first + path.count; ++i) {
    if (found_.corners >= kMostEdges) return;
    ++found_.corners;
    const Point before = point(i - 1), corner = point(i), after = point(i + 1);
    found_.right_as_drawn += is_right_angle(before, corner, after, 1.0, 1.0);
    if (std::abs(corner.x) > 360.0 || std::abs(corner.y) > 360.0) continue;
    found_.right_as_degrees += is_right_angle(before, corner, after, cosine_deg(corner.y), 1.0);
    found_.right_if_exchanged += is_right_angle(before, corner, after, 1.0, cosine_deg(corner.x));
  }
}

DrawingEvidence EvidenceCollector::evidence() const {
  DrawingEvidence evidence = found_;
  evidence.edge = median(edges_);
  evidence.door = median(doors_);
  evidence.tread = median(nearest_distances(steps_));
  return evidence;
}

}  // namespace mapwright::converter
