#include "navcore/engine/beam_table.hpp"

#include <cassert>
#include <numbers>
#include <numeric>

#include "navcore/rays/ray_fan.hpp"

namespace mapwright::navcore::engine {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

}  // namespace

BeamTable::BeamTable(const LaserModel& laser) : rays(laser.rays) {
  assert(laser.rays > 0 && laser.fov_deg > 0.0 && laser.fov_deg <= 360.0);
  assert(laser.max_range_m > 0.0 && laser.height_m >= 0.0);
  const std::size_t padded = padded_to_block(rays) + kBlock;
  cosine.assign(padded, 0.0F);
  sine.assign(padded, 0.0F);
  number.resize(padded);
  std::iota(number.begin(), number.end(), 0);
  const RayFan fan(laser);
  for (std::size_t i = 0; i < rays; ++i) {
    direction.push_back(fan[i]);
    cosine[i] = static_cast<float>(fan[i].x);
    sine[i] = static_cast<float>(fan[i].y);
  }
  const double fov = rays > 1 ? laser.fov_deg * kRadiansPerDegree : 0.0;
  half_fov = static_cast<float>(0.5 * fov);
  rays_per_radian = rays > 1 ? static_cast<float>(static_cast<double>(rays - 1) / fov) : 1.0F;
  half_past_middle = static_cast<float>(0.5 * static_cast<double>(rays));
  max_range_m = static_cast<float>(laser.max_range_m);
  out_of_range = static_cast<float>((1.0 - 1e-6) / laser.max_range_m);
  looks_ahead = rays == 1 || laser.fov_deg <= 180.0;
}

}  // namespace mapwright::navcore::engine
