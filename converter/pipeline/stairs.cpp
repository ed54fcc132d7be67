#include "converter/pipeline/stairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "converter/pipeline/laid_steps.hpp"
#include "converter/pipeline/outlines.hpp"
#include "converter/pipeline/walls.hpp"
#include "mapcore/angle.hpp"

namespace mapwright::converter {
namespace {

constexpr double kMostSteps = 1000.0;
constexpr double kSharpBend = 0.87;  // cosine of 30 degrees: fan stairs turn less from step to step

SegmentStyle style_of(const FeatureTask& task) {
  return {0.0, task.meaning.in_out, Semantic(task.meaning.segment_semantic)};
}

std::optional<int> step_count(const Meaning& meaning) {
  if (!meaning.steps || *meaning.steps < 1.0 || *meaning.steps > kMostSteps) return std::nullopt;
  return static_cast<int>(std::lround(*meaning.steps));
}

double rise_of(const Meaning& meaning, int count, const RuleSettings& settings) {
  if (meaning.rise_m && *meaning.rise_m > 0.0) return *meaning.rise_m;
  if (meaning.height_m && *meaning.height_m > 0.0) return *meaning.height_m / count;
  return settings.rise_m;
}

// Upwards, as a unit vector of the map frame: degrees clockwise from the source grid's north.
Point upwards(const FeatureTask& task) {
  const Point north = task.grid_north;
  const Point turn = unit_vector_deg(-*task.meaning.direction_deg);
  return {north.x * turn.x - north.y * turn.y, north.x * turn.y + north.y * turn.x};
}

std::vector<std::vector<Point>> drawn_lines(const FeatureTask& task, const Workspace& workspace) {
  std::vector<std::vector<Point>> lines;
  for (const auto& path : task.feature.geometry.paths) {
    if (path.role != PathRole::kLine) continue;
    auto clean = clean_path(task.feature.geometry, path, workspace.resolution);
    if (clean.points.size() > 1) lines.push_back(std::move(clean.points));
  }
  return lines;
}

std::vector<Step> laid_steps(const FeatureTask& task, const std::vector<std::vector<Point>>& risers,
                             double rise_m, const Workspace& workspace) {
  std::vector<Step> steps;
  for (const auto& riser : risers) {
    Step step;
    for (const Point p : riser) step.line.push_back(workspace.snapped(p));
    if (step.line.front() == step.line.back()) continue;
    step.step_no = static_cast<double>(steps.size() + 1);
    step.height_m = *step.step_no * rise_m;
    step.style = style_of(task);
    step.account = task.account;
    steps.push_back(std::move(step));
  }
  return steps;
}

// What cannot be laid still stands in the robot's way: a low outline or wall, which the laser
// passes.
void add_low_obstacle(const FeatureTask& task, const std::string& why, Workspace& workspace) {
  const double rise_m = rise_of(task.meaning, 1, workspace.settings);
  workspace.ledger.change(task.account, FindingCode::C217,
                          why + ": written as an obstacle as high as one step");
  const auto outlines =
      drawn_lines(task, workspace).empty() ? outlines_of(task, workspace) : std::vector<Outline>();
  if (outlines.empty())
    add_wall(task, rise_m, workspace);
  else
    add_outlines(task, outlines, rise_m, workspace);
}

std::string missing_for_polygon(const FeatureTask& task) {
  if (!step_count(task.meaning)) return "stairs without number of steps";
  if (!task.meaning.direction_deg) return "stairs without direction";
  return {};
}

std::string missing_for_line(const FeatureTask& task) {
  if (!task.meaning.upwards) return "stairs of which nothing says which end is up";
  if (!task.meaning.width_m || !(*task.meaning.width_m > 0.0)) return "stairs without width";
  return {};
}

double length_of(const std::vector<Point>& line) {
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) total += distance(line[i], line[i + 1]);
  return total;
}

// What is stated, else as many steps of usual depth as there is room for.
int steps_along(const std::vector<Point>& line, const FeatureTask& task, Workspace& workspace) {
  if (const auto stated = step_count(task.meaning)) return *stated;
  const double tread_m = workspace.settings.tread_m;
  const double room = std::clamp(std::round(length_of(line) / tread_m), 1.0, kMostSteps);
  const int count = static_cast<int>(room);
  char text[128];
  std::snprintf(text, sizeof text,
                "no number of steps is given: %d of them, %.2f m deep, were laid along its length",
                count, tread_m);
  workspace.ledger.change(task.account, FindingCode::C217, text);
  return count;
}

// Stretches of a line without sharp bend: stairs around a corner are several flights.
std::vector<std::vector<Point>> flights_along(const std::vector<Point>& line) {
  std::vector<std::vector<Point>> flights{{line[0], line[1]}};
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Point before = line[i - 1] - line[i - 2];
    const Point after = line[i] - line[i - 1];
    const bool sharp = dot(before, after) < kSharpBend * length(before) * length(after);
    if (sharp) flights.push_back({line[i - 1]});
    flights.back().push_back(line[i]);
  }
  return flights;
}

// Steps of each flight, by its share of the length.
std::vector<std::vector<std::vector<Point>>> risers_along(const std::vector<Point>& line,
                                                          double width_m, int count) {
  std::vector<std::vector<std::vector<Point>>> risers;
  const double total = length_of(line);
  double passed = 0.0;
  int laid = 0;
  for (const auto& flight : flights_along(line)) {
    passed += length_of(flight);
    const int share = static_cast<int>(std::lround(count * passed / total)) - laid;
    laid += share;
    if (share > 0) risers.push_back(risers_across_line(flight, width_m, share));
  }
  return risers;
}

std::vector<std::vector<std::vector<Point>>> risers_of(const FeatureTask& task,
                                                       Workspace& workspace) {
  std::vector<std::vector<std::vector<Point>>> flights;
  auto lines = drawn_lines(task, workspace);
  for (auto& line : lines) {
    if (!*task.meaning.upwards) std::reverse(line.begin(), line.end());
    const int count = steps_along(line, task, workspace);
    for (auto& flight : risers_along(line, *task.meaning.width_m, count)) {
      flights.push_back(std::move(flight));
    }
  }
  if (!lines.empty()) return flights;
  const int count = *step_count(task.meaning);
  for (const auto& outline : outlines_of(task, workspace)) {
    flights.push_back(risers_in_outline(outline.polygon.outer, upwards(task), count));
  }
  return flights;
}

}  // namespace

void StairsCollector::add_step(const FeatureTask& task, const std::string& place) {
  const Key key{place, task.meaning.stair_id};
  auto lines = drawn_lines(task, workspace_);
  if (lines.empty()) {
    return workspace_.ledger.drop(task.account, FindingCode::C204, "a step without length");
  }
  auto [found, is_new] = flights_.try_emplace(key);
  Flight& flight = found->second;
  if (is_new) {
    flight.draft = draft_for(task, ShapeType::kStairs);
    flight.draft.features.clear();
  }
  flight.draft.features.push_back(task.account);
  for (auto& line : lines) {
    flight.steps.push_back({std::move(line), task.meaning.height_m.value_or(0.0),
                            task.meaning.rise_m.value_or(0.0), task.meaning.step_no, style_of(task),
                            task.account});
  }
}

void StairsCollector::add_stairs(const FeatureTask& task, const std::string& place) {
  LaidStairs laid{{place, task.meaning.stair_id}, task.account, {}};
  // Whatever is written for them now is taken back if their steps turn up.
  std::vector<Draft> others = std::exchange(workspace_.drafts, {});
  const bool is_line = !drawn_lines(task, workspace_).empty();
  const std::string missing = is_line ? missing_for_line(task) : missing_for_polygon(task);
  if (!missing.empty()) {
    add_low_obstacle(task, missing, workspace_);
  } else {
    const auto flights = risers_of(task, workspace_);
    std::size_t laid_count = 0;
    for (const auto& risers : flights) laid_count += risers.size();
    const int count = step_count(task.meaning).value_or(static_cast<int>(laid_count));
    const double rise_m = rise_of(task.meaning, std::max(count, 1), workspace_.settings);
    for (const auto& risers : flights) {
      auto steps = laid_steps(task, risers, rise_m, workspace_);
      if (steps.empty()) continue;
      Draft draft = draft_for(task, ShapeType::kStairs);
      draft.obstacle.segments = flight_segments(std::move(steps), workspace_);
      workspace_.drafts.push_back(std::move(draft));
    }
  }
  laid.drafts = std::exchange(workspace_.drafts, std::move(others));
  laid_.push_back(std::move(laid));
}

void StairsCollector::finish() {
  for (auto& laid : laid_) {
    if (!laid.key.second.empty() && flights_.count(laid.key) > 0) {
      auto& account = workspace_.ledger.features[laid.account];
      account.reasons.clear();
      workspace_.ledger.drop(laid.account, FindingCode::C211,
                             "the steps of stairs " + laid.key.second + " are drawn one by one");
      continue;
    }
    const std::size_t offset = workspace_.drafts.size();
    for (auto& draft : laid.drafts) {
      if (draft.inner_of) *draft.inner_of += offset;
      workspace_.drafts.push_back(std::move(draft));
    }
  }
  for (auto& [key, flight] : flights_) {
    flight.draft.obstacle.segments = flight_segments(std::move(flight.steps), workspace_);
    workspace_.drafts.push_back(std::move(flight.draft));
  }
}

}  // namespace mapwright::converter
