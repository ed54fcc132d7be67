#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "cli/localize/answer_json.hpp"
#include "cli/localize/recorded_answer.hpp"
#include "cli/support/pose_json.hpp"

namespace mapwright::cli {
namespace {

// Of a LookSettings or a TrackingStage.
template <class Look>
Json look_json(const Look& look) {
  Json json;
  json["beams"] = look.beams;
  json["sigma"] = look.sigma_m;
  json["evidence"] = std::isfinite(look.evidence) ? Json(look.evidence) : Json(nullptr);
  return json;
}

Json iteration_json(const navcore::RecordedIteration& iteration, std::size_t n) {
  const auto& estimate = iteration.estimate;
  Json json;
  json["n"] = n;
  json["scan"] = iteration.scan;
  json["t"] = iteration.time_s;
  json["particles"] = iteration.update.particles;
  json["beams"] = iteration.beams;
  json["effective_particles"] = iteration.update.effective_particles;
  json["spread_m"] = estimate.spread_m;
  json["mode_share"] = estimate.mode_share;
  json["mode_spread_m"] = estimate.mode_spread_m;
  json["believes_converged"] = iteration.believes;
  json["estimate"] = pose_json(estimate.pose);
  if (iteration.reference) {
    json["position_error_m"] = iteration.position_error_m;
    json["heading_error_deg"] = iteration.heading_error.degrees();
    json["reference"] = pose_json(*iteration.reference);
  }
  if (iteration.particles.size() == 0) return json;
  json["ranges"] = iteration.seen.ranges;
  json["angles_deg"] = Json::array();
  for (std::size_t i = 0; i < iteration.seen.ranges.size(); ++i) {
    json["angles_deg"].push_back(iteration.seen.heading.degrees() +
                                 ray_angle_deg(iteration.seen.laser, i));
  }
  json["particle_set"] = particles_json(iteration.particles);
  return json;
}

Json error_json(const navcore::RecordedVerdict& verdict) {
  Json json;
  json["median"] = verdict.median_error_m ? Json(*verdict.median_error_m) : Json(nullptr);
  json["p95"] = verdict.p95_error_m ? Json(*verdict.p95_error_m) : Json(nullptr);
  return json;
}

void add_verdict(const JudgedRun& judged, Json& json) {
  if (!judged.verdict) return;
  const auto& verdict = *judged.verdict;
  json["converged_from_start"] = verdict.strict_from_start;
  json["right_from_scan"] =
      verdict.strict ? Json(judged.run.iterations[*verdict.right_from].scan) : Json(nullptr);
  json["way_m"] = verdict.strict ? Json(verdict.way_m) : Json(nullptr);
  json["position_error_m"] = error_json(verdict);
}

Json iterations_to_converge(const std::vector<JudgedRun>& runs) {
  std::vector<double> counts;
  for (const auto& [run, verdict] : runs) {
    if (verdict->strict) counts.push_back(static_cast<double>(*verdict->right_from + 1));
  }
  return spread_json(navcore::median_and_p95(counts));
}

}  // namespace

Json recorded_settings_json(const RecordedQuestion& question) {
  const auto& settings = question.settings;
  const auto& filter = settings.filter;
  Json json;
  json["likelihood"] = question.likelihood;
  json["log"] = question.log_path;
  json["odometry"] = question.odometry_path;
  json["particles"] = filter.particles;
  json["first_particles"] = filter.first_particles;
  json["search"] = look_json(settings.search);
  const auto& stages = settings.tracker.stages;
  json["track"] = stages.empty() ? look_json(settings.recover) : look_json(stages.back());
  json["max_range"] = settings.max_range_m;
  json["laser_height"] = settings.height_m;
  json["alpha"] = filter.likelihood.alpha;
  json["beta"] = filter.likelihood.beta;
  json["gamma"] = filter.likelihood.gamma;
  json["tracking"] = question.from_reference || settings.initial_pose.has_value();
  json["seed"] = question.seed;
  return json;
}

void write_recorded_run_json(std::ostream& out, const RecordedQuestion& question,
                             const JudgedRun& run) {
  Json json;
  json["schema"] = "mapwright.localize/1";
  json["converged"] = run.converged();
  json["estimate"] = pose_json(run.run.iterations.back().estimate.pose);
  add_verdict(run, json);
  json["iterations"] = Json::array();
  for (const auto& iteration : run.run.iterations) {
    json["iterations"].push_back(iteration_json(iteration, json["iterations"].size() + 1));
  }
  json["settings"] = recorded_settings_json(question);
  out << json.dump() << '\n';
}

void write_recorded_batch_json(std::ostream& out, const RecordedQuestion& question,
                               const std::vector<JudgedRun>& runs) {
  const RecordedSummary all = summarize(runs);
  Json json;
  json["schema"] = "mapwright.localize/1";
  json["trials"] = all.runs;
  json["converged"] = all.strict;
  json["converged_from_start"] = all.strict_from_start;
  json["iterations_to_converge"] = iterations_to_converge(runs);
  json["way_m"] = spread_json(all.way_m);
  json["position_error_m"] = spread_json(all.position_error_m);
  json["scans_believed"] = all.believed;
  json["scans_rightly_believed"] = all.rightly_believed;
  json["runs"] = Json::array();
  for (const auto& run : runs) {
    Json row;
    row["first_scan"] = run.run.first_scan;
    row["last_scan"] = run.run.last_scan;
    row["converged"] = run.converged();
    add_verdict(run, row);
    row["estimate"] = pose_json(run.run.iterations.back().estimate.pose);
    json["runs"].push_back(std::move(row));
  }
  json["settings"] = recorded_settings_json(question);
  out << json.dump() << '\n';
}

}  // namespace mapwright::cli
