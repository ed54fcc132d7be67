// Private to this folder: cut obstacles made whole again.
#pragma once

#include <cstdint>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright {

/// A part whose pieces are whole obstacles again.
struct Sewn {
  Map map;                    ///< the border is still the part's
  std::vector<bool> was_cut;  ///< by obstacle; its place in the order says nothing then
  std::vector<std::int64_t>
      torn;  ///< ids of pieces that are not what cutting gave: left as they are
};

/// True where some obstacle says that it is a piece of one that was cut.
bool has_pieces(const Map& map);

/// Takes pieces for the obstacles that their records hold, where cutting those at the map's border
/// gives these pieces again. So nothing that was changed in a piece, or of the border, is passed
/// over: such pieces are torn.
Sewn sewn(Map map);

}  // namespace mapwright
