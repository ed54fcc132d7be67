#include "navcore/localization/beam_sampling.hpp"

#include <algorithm>
#include <cassert>

namespace mapwright::navcore {

SampledScan sample_beams(const RecordedScan& scan, std::size_t beams, double max_range_m,
                         double height_m) {
  assert(beams >= 2 && scan.fan.beams >= 2);
  const std::size_t last = scan.fan.beams - 1;
  const std::size_t stride = (last + beams - 2) / (beams - 1);
  const std::size_t count = last / stride + 1;
  const std::size_t first = (last - (count - 1) * stride) / 2;
  const double width = static_cast<double>((count - 1) * stride);
  SampledScan result;
  result.laser = {count, width * scan.fan.step.degrees(), max_range_m, height_m};
  result.heading = beam_direction(scan.fan, first) + 0.5 * width * scan.fan.step;
  for (std::size_t i = 0; i < count; ++i) {
    result.ranges.push_back(std::min(scan.ranges[first + i * stride], max_range_m));
  }
  return result;
}

void TurnedWeigher::weigh(std::span<const double> scan, const LaserModel& laser,
                          const LikelihoodModel& likelihood, std::span<const Pose> poses,
                          std::span<double> log_factors, unsigned threads) const {
  std::vector<Pose> turned(poses.begin(), poses.end());
  for (Pose& pose : turned) pose.theta = pose.theta + heading_;
  weigher_->weigh(scan, laser, likelihood, turned, log_factors, threads);
}

}  // namespace mapwright::navcore
