// Localization by many places that are weighed against each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "navcore/localization/filter_settings.hpp"
#include "navcore/localization/particle_filter.hpp"
#include "navcore/localization/place_sampling.hpp"
#include "navcore/localization/pose_filter.hpp"
#include "navcore/localization/scan_weigher.hpp"

namespace mapwright::navcore {

/// A marginal particle filter (Klaas, de Freitas, Doucet 2005) by places. A ParticleFilter searches
/// the map with the first scan. The places it finds (cells of 1 m × 1 m × 20°) are tracked each by
/// particles of its own: odometry spreads them, and the next scan draws new ones around them and
/// weighs the place (sample_places), given where odometry may have led from each of the old ones
/// (MovedPoses). So a place's weight is an integral, not a matter of how near to its peak one of
/// few particles lay, and places that look the same weigh the same.
class PlaceFilter final : public PoseFilter {
 public:
  /// Keeps a reference to `weigher`. Requires settings.places, each with stages.
  PlaceFilter(const ScanWeigher& weigher, const LaserModel& laser, const FilterSettings& settings,
              std::uint64_t seed);

  bool start_anywhere(const FreeSpace& space, const std::optional<HeadingPrior>& heading) override;
  void start_at(const Pose& pose, double sigma_m, double sigma_deg,
                const FreeSpace* space = nullptr) override;

  /// Goes on from these particles, which something else has found; `space` as in start_at.
  void take(const ParticleSet& particles, const FreeSpace* space = nullptr);

  void move(const OdometryStep& step) override;
  UpdateReport update(std::span<const double> scan) override;
  const ParticleSet& particles() const override;

 private:
  void rest_at(CellSample places);
  void weigh_ways();
  bool looks_elsewhere() const { return space_ != nullptr && settings_.elsewhere_particles > 0; }
  std::vector<Place> searched_places();
  TrackedPrior prior_of(IndexRange cell, double here) const;
  std::vector<Place> tracked_places() const;
  std::vector<Place> elsewhere_places(std::span<const double> scan);
  std::vector<Pose> elsewhere_by_fit(std::span<const double> scan);
  UpdateReport search(std::span<const double> scan);
  UpdateReport weigh(std::vector<Place> places, std::span<const PlaceStage> stages,
                     std::span<const double> scan);
  CellSample kept(const ParticleSet& particles, std::size_t count);
  Random stream(std::size_t number) const;

  const ScanWeigher& weigher_;
  LaserModel laser_;
  FilterSettings settings_;
  PlaceSettings how_;
  std::uint64_t seed_;
  std::uint64_t epoch_ = 0;  ///< counts the operations that draw random numbers
  const FreeSpace* space_ = nullptr;
  double area_m2_ = 0.0;                 ///< of free space, about
  std::optional<HeadingPrior> heading_;  ///< what compass and odometry say
  ParticleFilter searcher_;
  bool lost_ = false;         ///< the searcher has started anywhere and not yet seen a scan
  bool coarse_ = false;       ///< the places come from somewhere else
  std::size_t sure_for_ = 0;  ///< scans in a row that one mode held enough weight
  CellSample places_;
  ParticleSet before_;                ///< the same particles before the last movement
  std::optional<OdometryStep> step_;  ///< the last movement, if it came after the last scan
};

/// The filter that the settings ask for: a PlaceFilter, or without places a ParticleFilter.
std::unique_ptr<PoseFilter> make_filter(const ScanWeigher& weigher, const LaserModel& laser,
                                        const FilterSettings& settings, std::uint64_t seed);

}  // namespace mapwright::navcore
