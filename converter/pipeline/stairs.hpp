// Stairs: from step lines, from a polygon with direction and step count, from a centre line.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// One riser as it is drawn.
struct Step {
  std::vector<Point> line;  ///< map frame, lower ground on the right once oriented
  double height_m = 0.0;    ///< of its upper edge above the foot of the flight; 0: not given
  double rise_m = 0.0;      ///< 0: not given
  std::optional<double> step_no;
  SegmentStyle style;
  std::size_t account = 0;
};

/// Puts the risers of one flight into the report's order (section 3.1): from the bottom, each with
/// lower ground on its right, heights cumulative, and a segment of height 0 the other way round
/// behind the last riser.
///
/// The closing segment lies one tread behind the upper edge of the flight (the longest edge of the
/// risers' convex hull that faces uphill; of a plain flight the last riser) and is as wide as all
/// risers together, so that from above no riser shows past it. Turned risers are told to the
/// ledger.
std::vector<Segment> flight_segments(std::vector<Step> steps, Workspace& workspace);

/// Stairs of a conversion; steps arrive one by one and become obstacles at the end.
class StairsCollector {
 public:
  explicit StairsCollector(Workspace& workspace) : workspace_(workspace) {}

  /// A feature of kind steps with a stair_id. `place` names the file or folder it comes from: ids
  /// are the same flight only within one.
  void add_step(const FeatureTask& task, const std::string& place);

  /// A feature of kind stairs. Where the steps of its flight are drawn, they count instead of it.
  void add_stairs(const FeatureTask& task, const std::string& place);

  /// Makes the obstacles.
  void finish();

 private:
  using Key = std::pair<std::string, std::string>;  // place, stair_id
  struct Flight {
    Draft draft;
    std::vector<Step> steps;
  };
  struct LaidStairs {
    Key key;
    std::size_t account = 0;
    std::vector<Draft> drafts;
  };

  Workspace& workspace_;
  std::map<Key, Flight> flights_;
  std::vector<LaidStairs> laid_;
};

}  // namespace mapwright::converter
