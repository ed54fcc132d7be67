// Places weighed against each other by importance sampling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "navcore/localization/filter_settings.hpp"
#include "navcore/localization/particles.hpp"
#include "navcore/localization/place_prior.hpp"
#include "navcore/localization/pose_belief.hpp"
#include "navcore/localization/scan_weigher.hpp"

namespace mapwright::navcore {

/// A place that the robot may be at.
struct Place {
  PlacePrior prior;
  PoseBelief proposal;         ///< where particles are drawn from first
  std::size_t count = 50;      ///< particles
  std::size_t from_stage = 0;  ///< what is known well needs no blunt look
};

/// A scan, and by what it is weighed.
struct ScanEvidence {
  std::span<const double> scan;
  LaserModel laser;
  LikelihoodModel likelihood;  ///< but for σm
  const ScanWeigher* weigher = nullptr;
  unsigned threads = 1;
};

/// What importance sampling has found: particles place after place; the weights sum up to 1 over
/// all places.
struct PlaceSample {
  ParticleSet particles;
  bool contradicted = false;  ///< the scan is impossible at all of them; equal weights
};

/// In each place particles are drawn around where the stage before has found the scan to agree, and
/// weighed in the last stage by prior × likelihood^τ / density they were drawn with. Their mean
/// estimates how likely the scan is if the robot is at that place, whatever number of particles a
/// place has, and with little noise, because they are drawn where the weight is. The last stage is
/// repeated in places where a smaller effective share than 0.3 of the particles matters (Cappé,
/// Guillin, Marin, Robert, Population Monte Carlo, 2004; a normal distribution for each place:
/// Kotecha, Djurić, Gaussian sum particle filtering, 2003). Place k draws from the stream
/// `first_stream` + k of `seed`. Requires stages, and places that begin by the last one.
PlaceSample sample_places(std::vector<Place> places, std::span<const PlaceStage> stages,
                          const ScanEvidence& evidence, std::uint64_t seed,
                          std::uint64_t first_stream);

/// Particles of each cell, in order of place.
struct CellSample {
  ParticleSet particles;
  std::vector<IndexRange> cells;  ///< each cell's particles; they weigh the same
};

/// About `count` particles: a cell with the share W of the weight gets them in proportion to
/// W^power, `least` at the least, low-variance by weight within. Cells below `negligible` get none,
/// nor do those beyond the `most_cells` heaviest.
struct CellSampling {
  std::size_t count = 6000;
  double power = 0.5;
  std::size_t least = 40;
  double negligible = 1e-9;
  std::size_t most_cells = 300;
};
CellSample sample_cells(const ParticleSet& particles, const CellSampling& how, Random& random);

}  // namespace mapwright::navcore
