// The fast ray caster: whole scans at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/localization/scan_weigher.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

struct ScanEngineOptions {
  /// Side of the cells that have a list each. Smaller cells have shorter lists, and there are more
  /// of them.
  double cell_size_m = 1.0;

  /// Memory for the lists of one laser, about: what one call needs is kept in any case.
  std::size_t cell_memory_bytes = std::size_t{256} << 20U;

  /// Instruction set, one of ScanEngine::instruction_sets(); empty: the best there is.
  std::string instruction_set;
};

/// Casts scans, not rays: in the sensor's frame 1/r along a segment is linear in the direction of
/// the ray, so a segment costs one multiplication, one multiply-add and one maximum for each of the
/// rays between the bearings of its ends (docs/scan-engine.md). Same rules as the other ray casters
/// (docs/rays.md), with ranges in single precision:
///
///     |error| <= (1e-6 m + 1.5e-7 RMAX) / sin(angle between ray and segment),
///
/// and which of two segments a ray meets that passes within 1e-5 m (RMAX 15 m) of an end is open.
/// No ray slips between segments that share an end. All instruction sets keep to this bound; their
/// last digits differ.
///
/// The map is divided into square cells. What rays from a cell can meet is listed when a pose first
/// falls into it; lists are kept per laser (the four used last), within a budget. Immutable to its
/// users and safe to use from many threads; the numbers depend on map, laser and pose only.
class ScanEngine final : public RayCaster, public ScanWeigher {
 public:
  /// Requires an instruction set that this machine has and a positive cell size.
  explicit ScanEngine(const Map& map, const ScanEngineOptions& options = {});
  ScanEngine(ScanEngine&&) noexcept;
  ScanEngine& operator=(ScanEngine&&) noexcept;
  ~ScanEngine() override;

  void cast(const Pose& pose, const LaserModel& laser, std::span<double> ranges) const override;
  void cast_all(std::span<const Pose> poses, const LaserModel& laser,
                std::span<double> ranges) const override;

  /// The same in single precision, without conversion. Uses up to `threads` threads (0: one a
  /// core); the numbers do not depend on how many.
  void cast_all(std::span<const Pose> poses, const LaserModel& laser, std::span<float> ranges,
                unsigned threads) const;

  /// Casts and weighs in one pass, in single precision: off by about 1e-5 of the sum of the
  /// exponents' magnitudes. Where the reference underflows to −∞ (robust, no floor) it is finite.
  void weigh(std::span<const double> scan, const LaserModel& laser,
             const LikelihoodModel& likelihood, std::span<const Pose> poses,
             std::span<double> log_factors, unsigned threads) const override;

  /// Range of one ray in any direction, in double precision; needs no cell.
  double cast_ray(Point origin, Angle direction, double height_m, double max_range_m) const;

  /// Names of the instruction sets that this machine has, best first.
  static std::vector<std::string_view> instruction_sets();
  std::string_view instruction_set() const;

  /// Bytes of the map's segments and their index; without the lists of cells.
  std::size_t scene_bytes() const;

  /// What the lists of the cells for one laser take now.
  struct CellStatistics {
    std::size_t cells = 0;
    std::size_t bytes = 0;
  };
  CellStatistics cell_statistics(const LaserModel& laser) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::navcore
