#include "converter/pipeline/stairs.hpp"

#include <algorithm>
#include <cmath>

#include "converter/pipeline/laid_steps.hpp"
#include "converter/pipeline/outlines.hpp"
#include "converter/pipeline/walls.hpp"
#include "mapcore/angle.hpp"

namespace mapwright::converter {
namespace {

constexpr double kMostSteps = 1000.0;

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
  if (!step_count(task.meaning)) return "stairs without number of steps";
  if (!task.meaning.upwards) return "stairs of which nothing says which end is up";
  if (!task.meaning.width_m || !(*task.meaning.width_m > 0.0)) return "stairs without width";
  return {};
}

std::vector<std::vector<std::vector<Point>>> risers_of(const FeatureTask& task,
                                                       Workspace& workspace) {
  std::vector<std::vector<std::vector<Point>>> flights;
  const int count = *step_count(task.meaning);
  auto lines = drawn_lines(task, workspace);
  for (auto& line : lines) {
    if (!*task.meaning.upwards) std::reverse(line.begin(), line.end());
    flights.push_back(risers_across_line(line, *task.meaning.width_m, count));
  }
  if (!lines.empty()) return flights;
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
    const double rise_m = rise_of(task.meaning, *step_count(task.meaning), workspace_.settings);
    for (const auto& risers : risers_of(task, workspace_)) {
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
