// Private to this folder: a few poses, for the kernels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "navcore/engine/aligned.hpp"

namespace mapwright::navcore::engine {

/// Poses prepared and cast together: what is known of them stays in the first-level cache.
inline constexpr std::size_t kMostPoses = 512;

/// The square grid of cells over the plane; cell (0, 0) has its lower left corner at the origin of
/// the map frame.
struct CellGrid {
  double cell_size_m = 0.0;
  double cells_per_metre = 0.0;
  double most_m = 0.0;  ///< cells have numbers where both coordinates are nearer to 0 than this
};

/// Column of poses where cells have no numbers.
inline constexpr std::int32_t kNowhere = INT32_MAX;

/// Poses in the map frame, and the same relative to their cells.
struct PiecePoses {
  template <class T>
  using Array = std::array<T, kMostPoses>;

  alignas(kLine) Array<double> x, y;     ///< metres
  alignas(kLine) Array<double> heading;  ///< radians
  alignas(kLine) Array<std::int32_t> column, row;
  alignas(kLine) Array<float> dx, dy;  ///< metres, from the centre of the cell
  alignas(kLine) Array<float> cosine, sine;
};

}  // namespace mapwright::navcore::engine
