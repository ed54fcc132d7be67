// Obstacles on their way into the map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "converter/ledger/ledger.hpp"
#include "converter/rules/meaning.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

/// Id and position of an obstacle in the map it was exported from.
struct Recorded {
  std::int64_t id = 0;
  std::size_t place = 0;  ///< which export it comes from
  std::int64_t position = 0;
};

/// An obstacle without its final id.
struct Draft {
  Obstacle obstacle;
  FeatureKind kind = FeatureKind::kSolid;  ///< with the layer, decides the order in the map
  std::size_t source = 0;                  ///< position in Ledger::sources
  std::vector<std::size_t> features;       ///< accounts in the ledger that went into it
  std::optional<std::size_t> inner_of;     ///< position of the outer ring's draft
  std::optional<Recorded> recorded;        ///< of obstacles that `export` wrote
};

/// What every segment of an obstacle shares.
struct SegmentStyle {
  double height_m = 0.0;
  InOut in_out = InOut::kOutdoor;
  Semantic semantic;
};

/// Chain of segments through the points; `closed` joins the last to the first.
std::vector<Segment> chain_of(const std::vector<Point>& points, bool closed,
                              const SegmentStyle& style);

}  // namespace mapwright::converter
