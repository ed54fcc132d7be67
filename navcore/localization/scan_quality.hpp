// Whether scans still fit the map as well as they used to.
#pragma once

#include <algorithm>
#include <cmath>

namespace mapwright::navcore {

/// Short-term and long-term averages of how well scans fit (augmented Monte Carlo localization:
/// Gutmann and Fox 2002; Thrun, Burgard, Fox, Probabilistic Robotics, 2005, table 8.3).
struct QualityDecay {
  double slow = 0.05;  ///< share of a new scan in the long-term average, in (0, 1]
  double fast = 0.5;   ///< in the short-term one; slow <= fast
};

class ScanQuality {
 public:
  explicit ScanQuality(const QualityDecay& decay) : decay_(decay) {}

  /// `fit` > 0: likelihood a beam, the geometric mean over the beams of a scan. While the robot is
  /// `lost` the long-term average stays as it is: nobody gets used to a wrong place.
  /// `news` in (0, 1]: as how much of a scan it counts; ten tenths come to one.
  void add(double fit, bool lost = false, double news = 1.0) {
    if (slow_ == 0.0) slow_ = fast_ = fit;
    if (!lost) slow_ += share(decay_.slow, news) * (fit - slow_);
    fast_ += share(decay_.fast, news) * (fit - fast_);
  }

  /// Elsewhere scans fit so: what they used to fit still counts.
  void begin_anew(double fit) { fast_ = fit; }

  /// max(0, 1 − short-term / long-term): the book's share of random particles.
  double share_lost() const { return slow_ > 0.0 ? std::max(0.0, 1.0 - fast_ / slow_) : 0.0; }

 private:
  static double share(double of_scan, double news) { return 1.0 - std::pow(1.0 - of_scan, news); }

  QualityDecay decay_;
  double slow_ = 0.0, fast_ = 0.0;
};

}  // namespace mapwright::navcore
