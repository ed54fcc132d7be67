// Private to this folder: the inner loops, once for each instruction set.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "navcore/engine/beam_table.hpp"
#include "navcore/engine/piece_poses.hpp"
#include "navcore/engine/scan_starts.hpp"
#include "navcore/engine/scan_weight.hpp"
#include "navcore/engine/scene.hpp"
#include "navcore/engine/workspace.hpp"

namespace mapwright::navcore::engine {

/// What all scans of a call have in common.
struct ScanSetup {
  const Scene* scene = nullptr;
  const BeamTable* beams = nullptr;
  double height_m = 0.0;

  /// Of a field of view up to 180°, what lies so far (metres) behind the laser comes near no ray.
  float behind_m = 0.0F;
};

/// How many scans from one cell share work.
struct GroupSize {
  std::uint32_t least;
  std::uint32_t most;  ///< a power of two
};

/// The kernels of one instruction set.
struct Kernels {
  std::string_view name;
  std::int64_t target;  ///< Highway's bit

  /// One scan from each start, `beams->rays` ranges (metres) each, at ranges[scan · rays].
  void (*cast)(const ScanSetup&, const ScanStarts&, Workspace&, float* ranges);

  /// Logarithms of the weights of the starts, each at log_weights[scan].
  void (*weigh)(const ScanSetup&, const ScanStarts&, Workspace&, const ScanWeight&,
                double* log_weights);

  GroupSize (*group_size)(const BeamTable&);

  /// Finds the cells of the first `count` poses and where in them the poses are. Up to a line of
  /// what lies beyond is overwritten.
  void (*place)(const CellGrid&, std::size_t count, PiecePoses&);
};

/// Kernels of all instruction sets this machine has and the build knows, best first; the last is
/// the build's baseline.
const std::vector<Kernels>& kernels_of_this_machine();

}  // namespace mapwright::navcore::engine
