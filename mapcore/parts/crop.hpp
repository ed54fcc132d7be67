// Parts of a map.
#pragma once

#include <cstddef>
#include <optional>

#include "mapcore/map.hpp"
#include "mapcore/result.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright {

/// A box, or the disc in it. Closed; metres, map frame.
struct CropRegion {
  Box box = kEmptyBox;
  std::optional<Point> center;  ///< of a disc; else the whole box counts
  double radius_m = 0.0;

  static CropRegion of_disc(Point center, double radius_m);
  bool touches(Point a, Point b) const;
};

struct CropOptions {
  bool cut = false;  ///< clip outlines and walls at the box; not for discs
  double resolution_m = tolerance::kResolution_m;  ///< of the corners that cutting makes
};

struct Crop {
  Map map;
  std::size_t dropped = 0;     ///< obstacles that are not in the part
  std::size_t cut = 0;         ///< obstacles that were clipped
  std::size_t protruding = 0;  ///< obstacles of the part that reach beyond its border
};

/// The obstacles that touch the region, in their order and with their ids; an outline comes with
/// all its holes, also where only one of them touches. A solid around the whole region counts, its
/// courtyard does not. The border is the region's box within the map's border.
///
/// With `cut`, outlines and walls end at the box; stairs and ramps stay whole, for a part of them
/// means something else (its top, its foot). A solid's new edges have its greatest height and the
/// semantic string "cut"; a room (clockwise, in no outline) becomes the walls of it that are left.
/// The first piece keeps the id and carries a token `cut=…` of which `merge` makes the whole
/// obstacle again; others get ids beyond the map's greatest and the token `part_of=<id>`.
///
/// Parts may be cropped again: of a part that was cut, the obstacles as they were are cropped, so
/// that it does not matter whether a map is cropped in one step or in several.
///
/// Fails (kUsage) where the region has no area in common with the border.
Result<Crop> crop(const Map& map, const CropRegion& region, const CropOptions& options = {});

}  // namespace mapwright
