// Private to this folder: segments that scans may meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/engine/aligned.hpp"

namespace mapwright::navcore::engine {

/// Lasers of the views that are searched together: a scan's, of walls or of a staircase.
struct LaserTable {
  alignas(kLine) float x[kBlock] = {};
  alignas(kLine) float y[kBlock] = {};
  alignas(kLine) float cosine[kBlock] = {};
  alignas(kLine) float sine[kBlock] = {};
};

/// A vector of segments of a cell's list, for one view.
struct BlockToSearch {
  const float* ends;  ///< ax; ay, bx and by are `stride` further each
  std::uint32_t stride;
  std::uint32_t first;  ///< segment of the cell's list
  std::uint32_t count;  ///< of segments that the vector holds
  std::uint32_t view;
};

/// Two blocks of a list are written at once, whether it has a second one or not.
inline constexpr std::size_t kUsualBlocks = 2;

struct BlocksToSearch {
  void clear() { size = 0; }
  void make_room(std::size_t more) {
    const std::size_t needed = size + more + kUsualBlocks;
    if (needed > blocks.size()) blocks.resize(2 * needed);
  }

  std::vector<BlockToSearch> blocks;
  std::size_t size = 0;
};

/// Those segments that lie in front of their lasers, of all views one after the other.
class Candidates {
 public:
  /// Makes room for so many more.
  void make_room(std::size_t more) {
    const std::size_t needed = size + more + kBlock;
    if (needed <= ax.size()) return;
    for (AlignedFloats* array : {&ax, &ay, &bx, &by}) array->resize(2 * needed);
    source.resize(2 * needed);
  }

  std::size_t size = 0;
  AlignedFloats ax, ay, bx, by;  ///< ends, relative to the centre of the view's cell
  AlignedInts source;            ///< kBlock · segment of the view's list + view
};

}  // namespace mapwright::navcore::engine
