// Private to this folder: segments that scans may meet.
#pragma once

#include <cstddef>

#include "navcore/engine/aligned.hpp"

namespace mapwright::navcore::engine {

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
  AlignedInts source;            ///< view, segment of its list, and what that is
};

}  // namespace mapwright::navcore::engine
