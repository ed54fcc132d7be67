#include "navcore/localization/scan_weigher.hpp"

#include <cassert>
#include <vector>

#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

// Poses that are cast together: enough to spread the set-up, few enough for the cache.
constexpr std::size_t kBatch = 64;

}  // namespace

void RayCastingWeigher::weigh(std::span<const double> scan, const LaserModel& laser,
                              const LikelihoodModel& likelihood, std::span<const Pose> poses,
                              std::span<double> log_factors, unsigned threads) const {
  assert(scan.size() == laser.rays && log_factors.size() == poses.size());
  parallel_for(poses.size(), kBatch, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> synthetic((end - begin) * laser.rays);
    caster_->cast_all(poses.subspan(begin, end - begin), laser, synthetic);
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const double> ranges(synthetic.data() + (i - begin) * laser.rays, laser.rays);
      log_factors[i] = log_weight_factor(scan, ranges, likelihood, laser.max_range_m);
    }
  });
}

}  // namespace mapwright::navcore
