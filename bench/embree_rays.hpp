// Embree as a planar ray caster, to compare with.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/map.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::bench {

/// Walls higher than the laser as upright quads in an Embree scene, rays in its plane. Stairs are
/// walls of their highest step and ramps nothing: less work than the report's rules ask for.
class EmbreeRays {
 public:
  /// False where the build found no Embree; then nothing else may be used.
  static bool is_available();

  /// How rays are handed over; always with the flag for coherent rays, which is the faster.
  enum class Mode { kSingle, kPacket4, kPacket8, kPacket16, kStream };
  static constexpr Mode kModes[] = {Mode::kSingle, Mode::kPacket4, Mode::kPacket8, Mode::kPacket16,
                                    Mode::kStream};
  static std::string name(Mode mode);

  EmbreeRays(const Map& map, double laser_height_m);
  ~EmbreeRays();

  /// Ranges of all scans, one after the other. Requires ranges.size() == poses.size() × rays.
  void cast(Mode mode, std::span<const Pose> poses, const navcore::LaserModel& laser,
            std::span<float> ranges) const;

  /// Bytes that Embree asked for.
  std::size_t memory_bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::bench
