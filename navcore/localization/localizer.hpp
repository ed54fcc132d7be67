// Localization scan by scan: search, tracking, recovery.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "navcore/free_space.hpp"
#include "navcore/localization/beam_sampling.hpp"
#include "navcore/localization/particle_filter.hpp"
#include "navcore/localization/pose_tracker.hpp"
#include "navcore/localization/scan_agreement.hpp"
#include "navcore/localization/scan_quality.hpp"

namespace mapwright::navcore {

/// How the filter looks at a scan.
struct LookSettings {
  std::size_t beams = 61;  ///< NL
  double sigma_m = 0.15;   ///< σm
  double evidence = 12.0;  ///< neighbouring beams err together: a scan counts as so many
                           ///< independent beams, whatever NL (τ = this / NL)
  std::size_t least_particles = 100;
  double elsewhere = 0.0;  ///< as in FilterSettings
  std::size_t elsewhere_particles = 0;
};

struct RecordedSettings {
  FilterSettings filter;
  double max_range_m = 25.0;    ///< longer readings say no more than that
  double height_m = 0.5;        ///< of the laser
  bool keep_particles = false;  ///< in the iterations, with what was seen

  /// A filter searches until it has been converged for a while: many particles, blunt, and the
  /// robot may be anywhere. Then a tracker goes on: few particles, sharp. While scans do not fit as
  /// they used to, a filter beside it looks for a place that fits better (it recovers, more soberly
  /// than it searches) and the tracker gives way when one has been found.
  LookSettings search, recover;
  /// Likelihood, odometry, range and height are those of the filter and the ones above.
  TrackerSettings tracker;    ///< without stages: the filter tracks too, as it recovers
  double confirmation = 5.0;  ///< converged for so many scans in a row
  double lost_share = 0.3;    ///< recovers where ScanQuality says more
  double patience = 10.0;     ///< searches all of the map after so many, twice as many, …
  double conviction = 20.0;   ///< logarithm of how many times more likely another place must be
  QualityDecay quality;
  /// A place where on average over the last scans a smaller share of the beams agrees with the map
  /// is doubted, even if no scan ever fitted better; where content_agreement do it is not, even if
  /// they did.
  double least_agreement = 0.0, content_agreement = 1.0;
  double agreement_decay = 0.15;  ///< share of a new scan in that average
  /// The search hands over no place where fewer agree, and begins anew after so many scans of them.
  double search_agreement = 0.0;
  double search_patience = 8.0;
  /// Another place must have been the better one for so many scans; and the tracker that gave way
  /// to it goes on beside it for so many, and takes over again if it turns out to be better.
  double conviction_scans = 0.0, regret_scans = 0.0;
  double regret = 6.0;  ///< as conviction, for the way back
  /// Scans from nearly the same place err alike. While it tracks, a scan counts in full after so
  /// much way (way_of, with the tracker's turn_m), after less in proportion, but never less than
  /// least_news: whoever stands still comes to doubt as well.
  double news_m = 0.5, least_news = 0.05;

  std::optional<Pose> initial_pose;  ///< tracking; else global localization, heading unknown
  double initial_sigma_m = 0.3;
  double initial_sigma_deg = 5.0;
};

/// Settings for recorded logs (docs/localization.md says where they come from).
RecordedSettings recorded_settings();

/// The report's filter to the letter, on all beams up to the report's 131.
RecordedSettings recorded_report_settings();

/// What a scan has shown.
struct LocalizerLook {
  std::size_t beams = 0;
  UpdateReport update;  ///< its particles count those of both filter and tracker
  PoseEstimate estimate;
  bool tracked = false;   ///< the estimate is the tracker's
  bool doubted = false;   ///< scans do not fit as they used to; another place is looked for
  bool believes = false;  ///< takes itself for converged, and does not doubt it
  SampledScan seen;       ///< with keep_particles
  ParticleSet particles;  ///< with keep_particles
};

/// Finds a robot's place and keeps it. The same settings, seed and inputs give the same answers for
/// any number of threads.
class Localizer {
 public:
  /// Keeps references to all three.
  Localizer(const FreeSpace& space, const ScanWeigher& weigher, const RecordedSettings& settings,
            std::uint64_t seed);

  /// At settings.initial_pose, or anywhere. False if the map has no free space to search.
  bool start();

  /// The robot moved; encoders say how.
  void drive(const OdometryStep& step);

  /// The robot took a scan.
  LocalizerLook look(const RecordedScan& scan);

 private:
  /// The tracker that gave way last, and how much better its place explains the scans since.
  struct Former {
    PoseTracker tracker;
    double advantage = 0.0;
    double scans = 0.0;
  };
  double news_since_last_scan();
  bool has_tracker() const { return !settings_.tracker.stages.empty(); }
  const ParticleSet& particles() const;
  void search(const RecordedScan& scan, LocalizerLook& result);
  void track(const RecordedScan& scan, LocalizerLook& result);
  void challenge(const RecordedScan& scan, double news, LocalizerLook& result);
  void weigh_challenger(const RecordedScan& scan, const PoseEstimate& estimate, double news,
                        LocalizerLook& result);
  void give_way(const PoseEstimate& estimate, double log_fit);
  bool is_regretted(const RecordedScan& scan, double fit, double news, LocalizerLook& result);
  void follow(const PoseEstimate& estimate);
  UpdateReport update_filter(const RecordedScan& scan, const LookSettings& how);
  SampledScan sample(const RecordedScan& scan, std::size_t beams) const;
  double agreement(double log_fit) const;
  bool is_doubtful() const;
  void begin_search_anew();
  double log_fit(const RecordedScan& scan, const Pose& pose) const;

  const FreeSpace& space_;
  const RecordedSettings& settings_;
  const ScanWeigher& weigher_;
  TurnedWeigher turned_;
  ParticleFilter filter_;
  PoseTracker tracker_;
  ScanQuality quality_;
  ScanAgreement agreement_;       ///< where the robot is taken to be
  ScanAgreement there_;           ///< at the challenger's place, since they are two
  double poor_for_ = 0.0;         ///< scans in a row that the search found too bad a place
  std::optional<Former> former_;  ///< goes on beside the tracker for a while
  std::size_t turned_beams_ = 0;  ///< that the filter looked at last
  bool tracking_ = false;         ///< the tracker knows the place
  bool challenged_ = false;       ///< the filter, beside it, looks for another
  bool everywhere_ = false;       ///< and has begun anew, in all of the map
  double advantage_ = 0.0;        ///< log of how much better the filter's place explains the scans
  Pose expected_;                 ///< what the search found last, moved since
  double sure_for_ = 0.0;         ///< scans in a row that the search was converged at one place
  double way_m_ = 0.0;            ///< since the last scan
  double lost_for_ = 0.0;         ///< scans in a row that fitted too badly, as they count
  double search_after_ = 0.0;     ///< of such scans: begins in all of the map
};

}  // namespace mapwright::navcore
