#include <ostream>

#include "cli/localize/answer_json.hpp"
#include "cli/localize/answer_writers.hpp"
#include "cli/support/laser_json.hpp"
#include "cli/support/pose_json.hpp"

namespace mapwright::cli {
namespace {

Json settings_json(const LocalizeQuestion& question) {
  const auto& settings = question.settings;
  const auto& likelihood = settings.filter.likelihood;
  Json json;
  json["likelihood"] = question.likelihood;
  json["particles"] = settings.filter.particles;
  json["first_particles"] = settings.filter.first_particles;
  add_laser(json, settings.laser, settings.laser_noise);
  json["alpha"] = likelihood.alpha;
  json["beta"] = likelihood.beta;
  json["gamma"] = likelihood.gamma;
  json["sigma"] = likelihood.sigma_m;
  json["temper"] = settings.filter.temper;
  json["compass_error_deg"] =
      settings.heading_known ? Json(settings.compass_error_deg) : Json(nullptr);
  json["known_start"] = settings.start_known;
  json["seed"] = question.seed;
  return json;
}

Json iteration_json(const navcore::IterationRecord& iteration,
                    const navcore::AccuracyBound& bound) {
  const auto& estimate = iteration.estimate;
  Json json;
  json["n"] = iteration.n;
  json["particles"] = iteration.update.particles;
  json["effective_particles"] = iteration.update.effective_particles;
  json["spread_m"] = estimate.spread_m;
  json["position_error_m"] = iteration.position_error_m;
  json["heading_error_deg"] = iteration.heading_error.degrees();
  json["mode_share"] = estimate.mode_share;
  json["mode_spread_m"] = estimate.mode_spread_m;
  json["believes_converged"] = iteration.believes;
  json["truth_advantage"] = iteration.truth_advantage;
  json["truth_share"] = iteration.truth_share;
  json["position_bound_m"] = finite_or_null(navcore::position_bound_m(bound));
  json["estimate"] = pose_json(estimate.pose);
  json["true_pose"] = pose_json(iteration.true_pose);
  if (iteration.particles.size() == 0) return json;
  json["scan"] = iteration.scan;
  json["particle_set"] = particles_json(iteration.particles);
  return json;
}

Json after_json(const navcore::TrialSummary::AfterIterations& after) {
  Json json;
  json["n"] = after.n;
  json["right"] = after.right;
  json["right_position"] = after.right_position;
  json["position_error_m"] = spread_json(after.position_error_m);
  return json;
}

Json run_summary_json(const navcore::ExperimentRun& run) {
  const auto& last = run.iterations.back();
  const auto from = run.right_from();
  Json json;
  json["seed"] = run.seed;
  json["start"] = pose_json(run.start);
  json["converged"] = run.converged();
  json["mistaken"] = run.mistaken();
  json["right_from"] = from ? Json(*from) : Json(nullptr);
  json["position_error_m"] = last.position_error_m;
  json["heading_error_deg"] = last.heading_error.degrees();
  json["truth_advantage"] = run.truth_advantage();
  json["truth_share"] = last.truth_share;
  json["truth_evidence"] = run.truth_evidence ? Json(*run.truth_evidence) : Json(nullptr);
  json["estimate"] = pose_json(last.estimate.pose);
  json["true_pose"] = pose_json(last.true_pose);
  return json;
}

Json reliability_json(const navcore::TrialSummary::Reliability& row) {
  Json json;
  json["from_share"] = row.from_share;
  json["iterations"] = row.iterations;
  json["mean_share"] = row.mean_share;
  json["right"] = row.right;
  return json;
}

Json tracking_json(const navcore::BoundSummary& tracking) {
  Json json;
  json["position_error_m"] = spread_json(tracking.error_m);
  json["rms_error_m"] = tracking.rms_error_m;
  json["rms_bound_m"] = tracking.rms_bound_m;
  json["rms_ratio"] = tracking.rms_error_m / tracking.rms_bound_m;
  return json;
}

}  // namespace

Json particles_json(const navcore::ParticleSet& particles) {
  Json array = Json::array();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose& pose = particles.poses[i];
    array.push_back(Json::array({pose.x, pose.y, plain_degrees(pose.theta), particles.weights[i]}));
  }
  return array;
}

Json spread_json(const std::optional<navcore::MedianAndP95>& spread) {
  Json json;
  json["median"] = spread ? Json(spread->median) : Json(nullptr);
  json["p95"] = spread ? Json(spread->p95) : Json(nullptr);
  return json;
}

void write_run_json(std::ostream& out, const LocalizeQuestion& question,
                    const navcore::ExperimentRun& run,
                    const std::vector<navcore::AccuracyBound>& bounds) {
  Json json;
  json["schema"] = "mapwright.localize/1";
  json["converged"] = run.converged();
  json["mistaken"] = run.mistaken();
  json["estimate"] = pose_json(run.iterations.back().estimate.pose);
  json["iterations"] = Json::array();
  for (const auto& iteration : run.iterations) {
    json["iterations"].push_back(iteration_json(iteration, bounds[iteration.n - 1]));
  }
  json["settings"] = settings_json(question);
  out << json.dump() << '\n';
}

void write_trials_json(std::ostream& out, const LocalizeQuestion& question,
                       const std::vector<navcore::ExperimentRun>& runs,
                       const TrialsAnswer& answer) {
  const navcore::TrialSummary& summary = answer.summary;
  Json json;
  json["schema"] = "mapwright.localize/1";
  json["trials"] = summary.trials;
  json["converged"] = summary.converged;
  json["mistaken"] = summary.mistaken;
  json["depleted"] = summary.depleted;
  json["alike"] = summary.alike;
  json["believed_iterations"] = summary.sure;
  json["believed_rightly"] = summary.sure_right;
  json["reliability"] = Json::array();
  for (const auto& row : summary.reliability) {
    json["reliability"].push_back(reliability_json(row));
  }
  json["tracking"] = answer.tracking ? tracking_json(*answer.tracking) : Json(nullptr);
  json["iterations_to_converge"] = spread_json(summary.iterations_to_converge);
  json["position_error_m"] = spread_json(summary.position_error_m);
  json["after"] = Json::array();
  for (const auto& after : summary.after) json["after"].push_back(after_json(after));
  json["runs"] = Json::array();
  for (const auto& run : runs) json["runs"].push_back(run_summary_json(run));
  json["settings"] = settings_json(question);
  out << json.dump() << '\n';
}

}  // namespace mapwright::cli
