// Private to this folder: the inner loops, once for each instruction set.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "mapcore/angle.hpp"
#include "navcore/engine/aligned.hpp"
#include "navcore/engine/beam_table.hpp"
#include "navcore/engine/packed_cell.hpp"
#include "navcore/engine/scan_weight.hpp"
#include "navcore/engine/scene.hpp"

namespace mapwright::navcore::engine {

/// What all scans of a call have in common.
struct ScanSetup {
  const Scene* scene = nullptr;
  const BeamTable* beams = nullptr;
  double height_m = 0.0;
};

/// A pose as the kernels want it.
struct ScanStart {
  float x = 0.0F, y = 0.0F;          ///< metres, relative to the cell's centre
  float cosine = 1.0F, sine = 0.0F;  ///< of the heading
  const PackedCell* cell = nullptr;
  const Pose* pose = nullptr;
};

/// Up to a block of segments on their way into the buffer of inverse ranges: 1/r =
/// cosine · cos φ + sine · sin φ for bearings from … to; first … last are the rays to look at.
struct alignas(kLine) SpanBlock {
  float cosine[kBlock], sine[kBlock], from[kBlock], to[kBlock];
  float first[kBlock], last[kBlock];  ///< rounded down when used
  std::uint32_t seen = 0;             ///< bit i: span i is in the field of view
  std::uint32_t near_line = 0;        ///< bit i: the segment's line runs through the laser, nearly
  std::uint32_t first_lane = 0;
};

/// Memory of one thread.
class Workspace {
 public:
  explicit Workspace(std::size_t padded_rays)
      : inverse(padded_rays),
        stops(padded_rays),
        low_steps(padded_rays),
        tops(padded_rays),
        differences(padded_rays) {}

  /// Inverse ranges of the part of a staircase that a lane belongs to.
  float* buffer_of(const PackedStairs& stairs, std::uint32_t lane) {
    return (stairs.is_top(lane) ? tops : stairs.is_stop(lane) ? stops : low_steps).data();
  }

  /// Forgets the blocks.
  void clear() {
    used = 0;
    ends.assign(1, 0);
  }
  /// Makes room for so many more blocks.
  void make_room(std::size_t more) {
    if (used + more > blocks.size()) blocks.resize(2 * (used + more));
  }
  /// The blocks since the last call are a section.
  void end_section() { ends.push_back(used); }
  std::span<const SpanBlock> section(std::size_t i) const {
    return {blocks.data() + ends[i], ends[i + 1] - ends[i]};
  }

  AlignedFloats inverse;                 ///< of the ranges, 1/m
  AlignedFloats stops, low_steps, tops;  ///< the same for one staircase
  AlignedFloats differences;             ///< of perceived and synthetic ranges, metres
  std::vector<SpanBlock, LineAllocator<SpanBlock>> blocks;
  std::size_t used = 0;

 private:
  std::vector<std::size_t> ends;
};

/// The kernels of one instruction set.
struct Kernels {
  std::string_view name;
  std::int64_t target;  ///< Highway's bit

  /// One scan from each start, `beams->rays` ranges (metres) each, one after the other.
  void (*cast)(const ScanSetup&, std::span<const ScanStart>, Workspace&, float* ranges);

  /// Logarithms of the weights of the starts, one each.
  void (*weigh)(const ScanSetup&, std::span<const ScanStart>, Workspace&, const ScanWeight&,
                double* log_weights);

  /// Cosines and sines of headings in radians.
  void (*turn)(std::span<const double> headings, double* cosines, double* sines);
};

/// Kernels of all instruction sets this machine has and the build knows, best first; the last is
/// the build's baseline.
const std::vector<Kernels>& kernels_of_this_machine();

}  // namespace mapwright::navcore::engine
