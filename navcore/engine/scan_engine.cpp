#include "navcore/engine/scan_engine.hpp"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <utility>

#include "navcore/engine/kernels.hpp"
#include "navcore/engine/scan_plan.hpp"
#include "navcore/engine/scan_weight.hpp"
#include "navcore/engine/single_ray.hpp"

namespace mapwright::navcore {
namespace {

using engine::Kernels;
using engine::ScanPlan;
using engine::ScanStarts;
using engine::Workspace;

constexpr std::size_t kMostPlans = 4;

const Kernels& chosen_kernels(std::string_view name) {
  const std::vector<Kernels>& all = engine::kernels_of_this_machine();
  if (name.empty()) return all.front();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Kernels& k) { return k.name == name; });
  assert(found != all.end());
  return *found;
}

bool same_laser(const LaserModel& p, const LaserModel& q) {
  return p.rays == q.rays && p.fov_deg == q.fov_deg && p.max_range_m == q.max_range_m &&
         p.height_m == q.height_m;
}

}  // namespace

struct ScanEngine::Impl {
  Impl(const Map& map, const ScanEngineOptions& given)
      : scene(map), options(given), kernels(&chosen_kernels(given.instruction_set)) {
    assert(given.cell_size_m > 0.0);
  }

  /// The plan for a laser, made when it is first asked for. The one used last stands in front.
  std::shared_ptr<const ScanPlan> plan(const LaserModel& laser) {
    const std::lock_guard lock(mutex);
    const auto found = std::find_if(plans.begin(), plans.end(), [&](const auto& plan) {
      return same_laser(plan->laser(), laser);
    });
    if (found != plans.end()) {
      std::rotate(plans.begin(), found, found + 1);
      return plans.front();
    }
    if (plans.size() == kMostPlans) plans.pop_back();
    plans.insert(plans.begin(), std::make_shared<const ScanPlan>(scene, laser, options.cell_size_m,
                                                                 options.cell_memory_bytes));
    return plans.front();
  }

  engine::Scene scene;
  ScanEngineOptions options;
  const Kernels* kernels;
  std::mutex mutex;
  std::vector<std::shared_ptr<const ScanPlan>> plans;
};

ScanEngine::ScanEngine(const Map& map, const ScanEngineOptions& options)
    : impl_(std::make_unique<Impl>(map, options)) {}
ScanEngine::ScanEngine(ScanEngine&&) noexcept = default;
ScanEngine& ScanEngine::operator=(ScanEngine&&) noexcept = default;
ScanEngine::~ScanEngine() = default;

void ScanEngine::cast(const Pose& pose, const LaserModel& laser, std::span<double> ranges) const {
  cast_all({&pose, 1}, laser, ranges);
}

void ScanEngine::cast_all(std::span<const Pose> poses, const LaserModel& laser,
                          std::span<double> ranges) const {
  assert(ranges.size() == poses.size() * laser.rays);
  const auto plan = impl_->plan(laser);
  const auto longest = static_cast<float>(laser.max_range_m);
  plan->for_poses(
      poses, *impl_->kernels, 1,
      [&](std::size_t first, std::size_t count, const ScanStarts& starts, Workspace& work) {
        std::vector<float> single(count * laser.rays);
        impl_->kernels->cast(plan->setup(), starts, work, single.data());
        const auto out = ranges.subspan(first * laser.rays, single.size());
        std::transform(single.begin(), single.end(), out.begin(), [&](float range) {
          return range < longest ? static_cast<double>(range) : laser.max_range_m;
        });
      });
}

void ScanEngine::cast_all(std::span<const Pose> poses, const LaserModel& laser,
                          std::span<float> ranges, unsigned threads) const {
  assert(ranges.size() == poses.size() * laser.rays);
  const auto plan = impl_->plan(laser);
  plan->for_poses(poses, *impl_->kernels, threads,
                  [&](std::size_t first, std::size_t, const ScanStarts& starts, Workspace& work) {
                    impl_->kernels->cast(plan->setup(), starts, work,
                                         ranges.data() + first * laser.rays);
                  });
}

void ScanEngine::weigh(std::span<const double> scan, const LaserModel& laser,
                       const LikelihoodModel& likelihood, std::span<const Pose> poses,
                       std::span<double> log_factors, unsigned threads) const {
  assert(log_factors.size() == poses.size());
  if (!(likelihood.alpha > 0.0)) {  // nothing but floors: not worth a kernel
    RayCastingWeigher(*this).weigh(scan, laser, likelihood, poses, log_factors, threads);
    return;
  }
  const engine::ScanWeight weight(scan, laser, likelihood);
  const auto plan = impl_->plan(laser);
  plan->for_poses(poses, *impl_->kernels, threads,
                  [&](std::size_t first, std::size_t, const ScanStarts& starts, Workspace& work) {
                    impl_->kernels->weigh(plan->setup(), starts, work, weight,
                                          log_factors.data() + first);
                  });
}

double ScanEngine::cast_ray(Point origin, Angle direction, double height_m,
                            double max_range_m) const {
  return engine::cast_ray(impl_->scene, origin, unit_vector_deg(direction.degrees()), height_m,
                          max_range_m);
}

std::vector<std::string_view> ScanEngine::instruction_sets() {
  std::vector<std::string_view> names;
  for (const Kernels& kernels : engine::kernels_of_this_machine()) names.push_back(kernels.name);
  return names;
}

std::string_view ScanEngine::instruction_set() const {
  return impl_->kernels->name;
}

std::size_t ScanEngine::scene_bytes() const {
  return impl_->scene.memory_bytes();
}

ScanEngine::CellStatistics ScanEngine::cell_statistics(const LaserModel& laser) const {
  const auto plan = impl_->plan(laser);
  return {plan->cell_count(), plan->cell_bytes()};
}

}  // namespace mapwright::navcore
