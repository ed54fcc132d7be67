#include "navcore/localization/filter_settings.hpp"

namespace mapwright::navcore {

FilterSettings report_settings() {
  FilterSettings settings;
  settings.first_particles = settings.particles;
  settings.likelihood = report_likelihood();
  return settings;
}

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
  return settings;
}

}  // namespace mapwright::navcore
