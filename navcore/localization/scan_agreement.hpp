// Whether scans agree with the map at all, on a scale that no earlier scan sets.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "navcore/localization/likelihood.hpp"

namespace mapwright::navcore {

/// Share of the beams that agree with the map, if each does wholly or not at all, of a scan whose
/// robust likelihood has the logarithm `log_fit` a beam: 1 where all end as the map says, 0 where
/// all have the uniform part's density (shorter and longer beams alike). Requires beta, gamma > 0.
inline double agreeing_share(double log_fit, const LikelihoodModel& model, double max_range_m) {
  const double none = std::log(std::sqrt(model.beta * model.gamma) / max_range_m);
  const double all = std::log(model.alpha / (model.sigma_m * std::sqrt(2.0 * std::numbers::pi)));
  return std::clamp((log_fit - none) / (all - none), 0.0, 1.0);
}

/// Average over the last scans, the later the heavier; from the first scan on it is one.
class ScanAgreement {
 public:
  /// `decay` in (0, 1]: share of a new scan.
  explicit ScanAgreement(double decay) : decay_(decay) {}

  /// `news` in (0, 1]: as how much of a scan it counts; ten tenths come to one.
  void add(double share, double news = 1.0) {
    const double part = 1.0 - std::pow(1.0 - decay_, news);
    sum_ += part * (share - sum_);
    known_ += part * (1.0 - known_);
    scans_ += news;
  }

  void begin_anew() { sum_ = known_ = scans_ = 0.0; }

  /// 0 before the first scan.
  double mean() const { return known_ > 0.0 ? sum_ / known_ : 0.0; }

  /// Since it began, as they count.
  double scans() const { return scans_; }

 private:
  double decay_;
  double sum_ = 0.0, known_ = 0.0, scans_ = 0.0;
};

}  // namespace mapwright::navcore
