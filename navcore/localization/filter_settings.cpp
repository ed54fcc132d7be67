#include "navcore/localization/filter_settings.hpp"

namespace mapwright::navcore {

FilterSettings report_settings() {
  FilterSettings settings;
  settings.first_particles = settings.particles;
  settings.likelihood = report_likelihood();
  return settings;
}

namespace {

PlaceSettings place_settings() {
  PlaceSettings places;
  places.first_stages = {{0.15, 0.3}, {0.1, 0.45}, {0.06, 0.6}};
  places.stages = {{0.4, 0.06}, {0.15, 0.25}, {0.08, 0.5}, {0.06, 0.6}};
  places.tracked_from_stage = 2;
  return places;
}

}  // namespace

FilterSettings robust_settings() {
  FilterSettings settings;
  settings.likelihood = {LikelihoodKind::kRobust, 1.0, 1.0, 0.5, 0.15};
  settings.temper = 0.3;
  settings.first_stages = 8;
  settings.first_sigma_m = 0.75;
  settings.keep_effective = 1.0;
  settings.sweeps = 1;
  settings.first_sweeps = 2;
  settings.place_power = 0.5;
  settings.elsewhere = 1e-3;
  settings.elsewhere_particles = 3000;
  settings.elsewhere_worth = 1e-6;
  settings.settled_share = 0.99;
  settings.places = place_settings();
  return settings;
}

}  // namespace mapwright::navcore
