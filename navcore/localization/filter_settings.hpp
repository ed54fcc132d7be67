// How a particle filter searches and tracks: its numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "navcore/localization/kld_sampling.hpp"
#include "navcore/localization/likelihood.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// One look at a scan, blunter or sharper than others.
struct PlaceStage {
  double sigma_m = 0.15;  ///< σm
  double temper = 0.3;    ///< τ
};

/// How a filter that tracks many places (PlaceFilter) weighs them against each other.
struct PlaceSettings {
  std::vector<PlaceStage> first_stages;  ///< for the first scan of a lost robot, after the search
  std::vector<PlaceStage> stages;        ///< for each other scan
  std::size_t tracked_from_stage = 0;    ///< of `stages`: what is tracked needs no blunt look
  std::size_t first_particles = 20000;   ///< that the first scan of a lost robot is weighed by
  std::size_t least_particles = 120;     ///< of a place
  double negligible = 1e-9;              ///< places with less of the weight are given up
  std::size_t most_places = 300;

  /// Of the extra particles that stand for somewhere else, so many cells are looked at, those that
  /// agree best with the scan, each with so many particles.
  std::size_t elsewhere_places = 24;
  std::size_t elsewhere_particles = 40;

  /// A disc of this radius does not drive through what blocks it: a particle that would have had to
  /// loses all but this share of its weight. Not all: maps are drawn by people.
  double robot_radius_m = 0.0;
  double through_barrier = 0.01;

  /// Once one mode has held this share of the weight for so many scans in a row, fewer particles go
  /// on. More than 1: never.
  double settled_share = 0.99;
  std::size_t settled_after = 3;
  std::size_t settled_particles = 1500;
};

/// How a filter searches and tracks. `report_settings` and `robust_settings` give sets that belong
/// together; docs/localization.md says where the numbers come from.
struct FilterSettings {
  std::size_t particles = 6000;         ///< NP
  std::size_t first_particles = 50000;  ///< scored against the first scan when lost; >= particles
  LikelihoodModel likelihood;
  double temper = 1.0;  ///< τ: exponent of each scan's factor, in (0, 1]

  /// Once one mode has held this share of the weight for so many scans in a row, the filter is
  /// settled: it goes on with fewer particles and looks at each scan twice, first as above, then by
  /// degrees more sharply, until by this σm and τ. More than 1: never.
  double settled_share = 2.0;
  std::size_t settled_after = 3;
  std::size_t settled_particles = 1500;
  double settled_sigma_m = 0.06;
  double settled_temper = 0.6;
  std::size_t settled_stages = 3;

  double resample_below = 0.5;  ///< resample when the effective share falls below this

  /// The first scan of a lost robot is brought to bear in this many steps, from a blunt likelihood
  /// to the one above: σm falls from `first_sigma_m`, the exponent rises from near 0.
  std::size_t first_stages = 1;
  double first_sigma_m = 0.5;

  /// Between its stages the first particles are thinned out to this many times their effective
  /// number, but to no fewer than `particles`: a place that a few of them stand for is not left to
  /// chance. 0: to `particles` at once.
  double keep_effective = 0.0;

  /// Resampling gives a place (PlaceGrid, particles.hpp) that holds the share W of the weight
  /// particles in proportion to W to this power, and the particles the weight that makes up for it.
  /// 1: by weight alone. Less: a place that the scans speak against keeps some particles, with all
  /// that was ever seen in their weight, and comes back when later scans speak for it.
  double place_power = 1.0;

  /// Metropolis sweeps after each resampling and at each stage: every particle tries that many
  /// random moves and keeps those that the scan agrees with. Their lengths (standard deviations)
  /// are spread evenly over the orders of magnitude between these limits.
  std::size_t sweeps = 0;
  std::size_t first_sweeps = 0;  ///< the same at the first scan of a lost robot, if more
  double least_part =
      1.0 / 16.0;  ///< a scan is brought to bear in no smaller parts of its evidence
  double shortest_move_m = 0.04, longest_move_m = 0.8;
  double smallest_turn_deg = 0.2, largest_turn_deg = 4.0;

  /// The robot may be elsewhere than odometry says (kidnapped, or its place lost among the
  /// particles): with this probability before each later scan it is anywhere in free space, which
  /// so many extra particles stand for. When tracking from a known pose, only if free space is
  /// given.
  double elsewhere = 0.0;
  std::size_t elsewhere_particles = 0;
  double elsewhere_worth = 1e-3;  ///< they are dropped when the scan leaves them less weight

  /// Where the odometry itself may be wrong, a share of them stays near: a wheel that slipped, a
  /// turn that was not counted. Around the particles, by these standard deviations; with
  /// probability 1/2 at any heading.
  double nearby_share = 0.0;
  double nearby_m = 0.3;
  double nearby_deg = 15.0;

  /// With them the default's PlaceFilter goes on from the search with the first scan; a
  /// ParticleFilter does without.
  std::optional<PlaceSettings> places;

  std::optional<KldSettings> kld;  ///< adaptive NP, from kld->least to `particles`

  OdometryNoise odometry;
  unsigned threads = 1;  ///< 0: one a core
};

/// The report's filter: 6000 particles from the start, Eq. (4)-(6) to the letter.
FilterSettings report_settings();

/// The default: robust likelihood, dense and annealed first scan, resample-move.
FilterSettings robust_settings();

}  // namespace mapwright::navcore
