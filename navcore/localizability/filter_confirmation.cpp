#include "navcore/localizability/filter_confirmation.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "navcore/localizability/edge_information.hpp"
#include "navcore/localization/experiment.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

enum Stream : std::uint64_t { kPlaces = 0x10ca, kTracking, kPairs, kGlobal };

/// What all runs share.
struct Ground {
  const FreeSpace& space;
  const LocalizabilityField& field;
  const LocalizabilitySettings& settings;
  const ConfirmationSettings& asked;
  GradientCaster caster;
  ScanEngine engine;
  BeamNoise noise;
};

/// Eq. (5) with the noise that the scans have: what makes a filter efficient.
LikelihoodModel true_likelihood(const LaserNoise& noise) {
  LikelihoodModel model;
  model.alpha = 1.0 - noise.occlusion;
  model.beta = std::max(noise.occlusion, 1e-3);
  model.gamma = std::max(noise.occlusion, 1e-3);
  model.sigma_m = noise.sigma_m;
  return model;
}

FilterSettings tracking_filter(const Ground& ground) {
  FilterSettings filter = robust_settings();
  filter.particles = ground.asked.particles;
  filter.likelihood = true_likelihood(ground.settings.noise);
  filter.temper = 1.0;
  filter.elsewhere = 0.0;
  filter.elsewhere_particles = 0;
  filter.sweeps = 3;
  filter.shortest_move_m = 0.003;
  filter.longest_move_m = 0.3;
  filter.smallest_turn_deg = 0.02;
  filter.largest_turn_deg = 2.0;
  filter.threads = 1;
  return filter;
}

PoseInformation belief(const ConfirmationSettings& asked) {
  const double sigma_rad = asked.start_sigma_deg * std::numbers::pi / 180.0;
  PoseInformation prior;
  prior.xx = prior.yy = 1.0 / (asked.start_sigma_m * asked.start_sigma_m);
  prior.tt = 1.0 / (sigma_rad * sigma_rad);
  return prior;
}

TrackedPlace predicted(const Ground& ground, const Pose& pose, Angle& major) {
  const LaserModel& laser = ground.settings.laser;
  std::vector<RangeGradient> scan(laser.rays);
  ground.caster.cast(pose, laser, scan);
  PoseInformation information = scan_information(scan, ground.noise.information_per_m2());
  information += belief(ground.asked);
  const AccuracyBound bound = accuracy_bound(information);
  information += edge_information(scan, pose, laser, ground.noise);
  const AccuracyBound edges = accuracy_bound(information);
  major = bound.major_direction;
  const Angle minor = major + Angle::from_degrees(90.0);
  TrackedPlace place;
  place.pose = pose;
  place.bound_major_m = bound.major_m;
  place.bound_minor_m = bound.minor_m;
  place.edges_major_m = edges.along_m(major);
  place.edges_minor_m = edges.along_m(minor);
  place.bound_heading_rad = bound.heading_rad;
  return place;
}

TrackedPlace track(const Ground& ground, const Pose& pose, std::uint64_t seed) {
  Angle major;
  TrackedPlace place = predicted(ground, pose, major);
  const Point u = unit_vector(major);
  const double to_rad = std::numbers::pi / 180.0;
  for (std::size_t run = 0; run < ground.asked.runs; ++run) {
    Random random(seed + run, kTracking);
    const auto scan =
        perceive(ground.engine, pose, ground.settings.laser, ground.settings.noise, random);
    const Pose believed{pose.x + random.normal(0.0, ground.asked.start_sigma_m),
                        pose.y + random.normal(0.0, ground.asked.start_sigma_m),
                        pose.theta + Angle::from_radians(random.normal(
                                         0.0, ground.asked.start_sigma_deg * to_rad))};
    ParticleFilter filter(ground.engine, ground.settings.laser, tracking_filter(ground),
                          seed + run);
    filter.start_at(believed, ground.asked.start_sigma_m, ground.asked.start_sigma_deg);
    filter.update(scan);
    const Pose estimate = filter.estimate().pose;
    const Point error = estimate.position() - pose.position();
    const double turn = (estimate.theta - pose.theta).wrapped().radians();
    place.seen_major_m += dot(u, error) * dot(u, error);
    place.seen_minor_m += cross(u, error) * cross(u, error);
    place.seen_heading_rad += turn * turn;
  }
  const double n = static_cast<double>(ground.asked.runs);
  place.seen_major_m = std::sqrt(place.seen_major_m / n);
  place.seen_minor_m = std::sqrt(place.seen_minor_m / n);
  place.seen_heading_rad = std::sqrt(place.seen_heading_rad / n);
  return place;
}

/// What came of one place and its twin.
struct TwinTrial {
  ConfusionBounds bounds;
  std::size_t pair_mistakes = 0;
  std::size_t global_mistakes = 0;
};

double log_likelihood(std::span<const double> scan, std::span<const double> ranges,
                      const LikelihoodModel& model, const LaserModel& laser) {
  // A beam without echo is one reading, not a range near the greatest.
  const double miss = std::log(std::max(model.beta / laser.max_range_m, 1e-12));
  const double hit = std::log(model.alpha / (model.sigma_m * std::sqrt(2.0 * std::numbers::pi)));
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const bool here = scan[i] < laser.max_range_m;
    const bool there = ranges[i] < laser.max_range_m;
    if (!here && !there) sum += hit;
    if (here != there) sum += miss;
    if (here && there) {
      sum += log_weight_factor(scan.subspan(i, 1), ranges.subspan(i, 1), model, laser.max_range_m);
    }
  }
  return sum;
}

// The likelier of the two, for scans (and compass readings) from each of the two by turns.
std::size_t pair_mistakes(const Ground& ground, const Pose& here, const Pose& there,
                          std::uint64_t seed) {
  const LaserModel& laser = ground.settings.laser;
  const LikelihoodModel model = true_likelihood(ground.settings.noise);
  const Pose poses[] = {here, there};
  std::vector<double> ranges[2];
  for (int k = 0; k < 2; ++k) {
    ranges[k].resize(laser.rays);
    ground.engine.cast(poses[k], laser, ranges[k]);
  }
  const auto compass_term = [&](double reading_deg, const Pose& pose) {
    if (!ground.settings.compass_sigma_deg) return 0.0;
    const double turn = (Angle::from_degrees(reading_deg) - pose.theta).wrapped().degrees() /
                        *ground.settings.compass_sigma_deg;
    return -0.5 * turn * turn;
  };
  std::size_t mistakes = 0;
  for (std::size_t i = 0; i < ground.asked.pair_tests; ++i) {
    Random random(seed + i, kPairs);
    const int truth = static_cast<int>(i % 2);
    std::vector<double> scan = ranges[truth];
    add_noise(scan, laser, ground.settings.noise, random);
    const double reading_deg = poses[truth].theta.degrees() +
                               random.normal(0.0, ground.settings.compass_sigma_deg.value_or(0.0));
    double likelihood[2];
    for (int k = 0; k < 2; ++k) {
      likelihood[k] =
          log_likelihood(scan, ranges[k], model, laser) + compass_term(reading_deg, poses[k]);
    }
    // Of scans that tell nothing, half are mistaken whatever one says: the first place is said.
    const bool tie = likelihood[0] == likelihood[1];
    mistakes += (tie ? truth == 1 : likelihood[1 - truth] > likelihood[truth]) ? 1 : 0;
  }
  return mistakes;
}

std::size_t global_mistakes(const Ground& ground, const Pose& pose, std::uint64_t seed) {
  ExperimentSettings experiment;
  experiment.laser = ground.settings.laser;
  experiment.laser_noise = ground.settings.noise;
  experiment.iterations = 1;
  experiment.heading_known = ground.settings.compass_sigma_deg.has_value();
  experiment.compass_error_deg = ground.settings.compass_sigma_deg.value_or(0.0);
  experiment.robot_radius_m = ground.settings.robot_radius_m;
  experiment.filter.threads = 1;
  std::size_t mistakes = 0;
  for (std::size_t i = 0; i < ground.asked.global_runs; ++i) {
    const auto run =
        run_experiment(ground.space, ground.engine, ground.engine, experiment, pose, seed + i);
    const bool lost = run && run->iterations.back().position_error_m > ground.settings.apart_m;
    mistakes += lost ? 1 : 0;
  }
  return mistakes;
}

TwinTrial try_twin(const Ground& ground, std::size_t cell, std::uint64_t seed) {
  const auto& twin = ground.field.twins[cell].worst;
  const Point p = ground.field.grid.center(cell);
  Random random(seed, kGlobal);
  const double heading = twin ? twin->heading_deg : 90.0 * static_cast<double>(random.below(4));
  const Pose pose{p.x, p.y, Angle::from_degrees(heading)};
  TwinTrial trial;
  trial.global_mistakes = global_mistakes(ground, pose, seed);
  if (!twin) return trial;
  // What the field says of the place between those looked at is a guess: here the pair counts.
  std::vector<RangeGradient> here(ground.settings.laser.rays), there(here.size());
  ground.caster.cast(pose, ground.settings.laser, here);
  ground.caster.cast(twin->pose, ground.settings.laser, there);
  TwinSettings twins;
  twins.compass_sigma_deg = ground.settings.compass_sigma_deg;
  trial.bounds =
      confusion_bounds(distinction_nats(here, there, pose, twin->pose, twins, ground.noise));
  trial.pair_mistakes = pair_mistakes(ground, pose, twin->pose, seed);
  return trial;
}

std::vector<std::size_t> drawn(std::vector<std::size_t> cells, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < std::min(count, cells.size()); ++i) {
    std::swap(cells[i], cells[i + random.below(cells.size() - i)]);
  }
  cells.resize(std::min(count, cells.size()));
  return cells;
}

RatioSpread ratios(const std::vector<TrackedPlace>& places, double TrackedPlace::*seen,
                   double TrackedPlace::*predicted) {
  std::vector<double> ratio;
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (const auto& place : places) {
    const double x = std::log(place.*predicted), y = std::log(place.*seen);
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    ratio.push_back(place.*seen / place.*predicted);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  if (ratio.empty()) return {};
  std::sort(ratio.begin(), ratio.end());
  const double n = static_cast<double>(ratio.size());
  const auto at = [&](double share) {
    return ratio[static_cast<std::size_t>(std::max(1.0, std::ceil(share * n))) - 1];
  };
  const double spread = (n * sxx - sx * sx) * (n * syy - sy * sy);
  return {at(0.1), at(0.5), at(0.9), spread > 0.0 ? (n * sxy - sx * sy) / std::sqrt(spread) : 0.0};
}

std::vector<RiskClass> risk_classes() {
  std::vector<RiskClass> classes;
  const double limits[] = {0.0, 1e-6, 1e-3, 1e-2, 0.1, 0.3, 0.5};
  for (std::size_t i = 0; i + 1 < std::size(limits); ++i) {
    RiskClass next;
    next.from = limits[i];
    next.to = limits[i + 1];
    classes.push_back(next);
  }
  return classes;
}

std::vector<RiskClass> by_risk(const Ground& ground, const std::vector<TwinTrial>& trials) {
  std::vector<RiskClass> classes = risk_classes();
  for (const auto& trial : trials) {
    auto& own = *std::find_if(classes.begin(), classes.end(), [&](const auto& c) {
      return trial.bounds.least <= c.to || &c == &classes.back();
    });
    ++own.places;
    own.predicted_least += trial.bounds.least;
    own.predicted_most += trial.bounds.most;
    if (trial.bounds.most > 0.0) {
      own.pair_tests += ground.asked.pair_tests;
      own.pair_mistakes += trial.pair_mistakes;
    }
    own.global_runs += ground.asked.global_runs;
    own.global_mistakes += trial.global_mistakes;
  }
  for (auto& c : classes) {
    if (c.places == 0) continue;
    c.predicted_least /= static_cast<double>(c.places);
    c.predicted_most /= static_cast<double>(c.places);
  }
  return classes;
}

}  // namespace

Confirmation confirm(const Map& map, const FreeSpace& space, const LocalizabilityField& field,
                     const LocalizabilitySettings& settings,
                     const ConfirmationSettings& confirmation, const Progress& progress) {
  const Ground ground{space,
                      field,
                      settings,
                      confirmation,
                      GradientCaster(map),
                      ScanEngine(map),
                      BeamNoise(settings.noise, settings.laser.max_range_m)};
  std::vector<std::size_t> standing, risky;
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    if (field.stands[i] == 0) continue;
    standing.push_back(i);
    if (field.worst_risk(i) > 0.01) risky.push_back(i);
  }
  Random random(confirmation.seed, kPlaces);
  const auto cells = drawn(standing, confirmation.places, random);
  std::vector<Pose> poses;
  for (const std::size_t cell : cells) {
    const Point p = field.grid.center(cell);
    poses.push_back(
        {p.x, p.y,
         Angle::from_degrees(settings.heading_deg.value_or(random.uniform(-180.0, 180.0)))});
  }
  std::vector<std::size_t> twin_cells;
  if (settings.look_for_twins) {
    twin_cells = drawn(risky, confirmation.places / 2, random);
    const auto others = drawn(standing, confirmation.places - twin_cells.size(), random);
    twin_cells.insert(twin_cells.end(), others.begin(), others.end());
  }
  Confirmation result;
  result.tracked.resize(cells.size());
  std::vector<TwinTrial> trials(twin_cells.size());
  const std::size_t total = cells.size() + twin_cells.size();
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(total, 1, settings.threads, [&](std::size_t i, std::size_t) {
    const std::uint64_t seed = confirmation.seed + 1'000'003 * (i + 1);
    if (i < cells.size()) {
      result.tracked[i] = track(ground, poses[i], seed);
    } else {
      trials[i - cells.size()] = try_twin(ground, twin_cells[i - cells.size()], seed);
    }
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, total);
  });
  using T = TrackedPlace;
  result.major_to_bound = ratios(result.tracked, &T::seen_major_m, &T::bound_major_m);
  result.minor_to_bound = ratios(result.tracked, &T::seen_minor_m, &T::bound_minor_m);
  result.major_to_edges = ratios(result.tracked, &T::seen_major_m, &T::edges_major_m);
  result.minor_to_edges = ratios(result.tracked, &T::seen_minor_m, &T::edges_minor_m);
  result.heading_to_bound = ratios(result.tracked, &T::seen_heading_rad, &T::bound_heading_rad);
  if (!trials.empty()) result.risks = by_risk(ground, trials);
  return result;
}

}  // namespace mapwright::navcore
