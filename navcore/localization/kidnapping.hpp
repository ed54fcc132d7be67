// A recorded robot that is carried off.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "navcore/localization/recorded_run.hpp"

namespace mapwright::navcore {

/// Two stretches of a log as one way: after the last scan of the first, the robot is put down where
/// the second begins. Odometry does not notice (it neither jumps nor moves there), and the clock
/// goes on by the first stretch's mean time between scans.
std::vector<RecordedStep> spliced(std::span<const RecordedStep> first,
                                  std::span<const RecordedStep> second);

/// How a run over two stretches ended.
struct KidnappingVerdict {
  bool right_before = false;  ///< at the last scan before the robot was carried off
  bool recovered = false;     ///< the rest of the run is strictly localized (RecordedVerdict)
  std::size_t scans = 0;      ///< that it took: 1 if right from the first scan elsewhere on
  double way_m = 0.0;         ///< driven meanwhile, by the reference
  double carried_m = 0.0;     ///< as the crow flies
};

/// `before` iterations of the run belong to the first stretch (0 < before < all). Requires a
/// reference in every iteration.
KidnappingVerdict judge_kidnapping(const RecordedRun& run, std::size_t before);

}  // namespace mapwright::navcore
