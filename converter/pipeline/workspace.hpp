// What the builders of one conversion share.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converter/ledger/ledger.hpp"
#include "converter/pipeline/clean_path.hpp"
#include "converter/pipeline/draft.hpp"
#include "converter/pipeline/map_transform.hpp"
#include "converter/pipeline/plain_obstacles.hpp"
#include "mapcore/geometry/ring_repair.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {

struct Workspace {
  Workspace(const RuleSettings& rule_settings, double resolution_m)
      : settings(rule_settings), resolution(resolution_m), plain(resolution_m) {}

  Point snapped(Point p) const { return {resolution.rounded(p.x), resolution.rounded(p.y)}; }
  Snap snap() const {
    return [this](Point p) { return snapped(p); };
  }

  RuleSettings settings;
  text::DecimalFormat resolution;
  bool repair = true;
  std::vector<Draft> drafts;
  std::vector<Point> ring;  ///< used again from feature to feature
  PlainObstacles plain;     ///< solids, rooms and walls that nothing has to be done about any more
  Ledger ledger;
  std::vector<std::string> warnings;      ///< about layers, for the person who converts
  bool is_incomplete = false;             ///< a layer yielded fewer features than it declares
  Box border = kEmptyBox;                 ///< drawn by features of kind border
  std::optional<Border> exported_border;  ///< as `export` wrote it; counts before the drawn one
};

/// A feature in the map frame, with what its rule makes of it.
struct FeatureTask {
  const SourceFeature& feature;  ///< coordinates in the map frame
  const Meaning& meaning;
  std::size_t account = 0;     ///< in the ledger
  std::size_t source = 0;      ///< position in Ledger::sources
  Point grid_north{0.0, 1.0};  ///< of the source, seen from the map frame
  bool is_plain = false;       ///< what it becomes may go to Workspace::plain
};

/// Height of a solid or wall: what the rule read, else the default (and a remark).
double height_of(const FeatureTask& task, Workspace& workspace);

/// A draft with the feature's semantics; segments are yet to come.
Draft draft_for(const FeatureTask& task, ShapeType shape_type);

/// The shape of an obstacle for Workspace::plain.
struct PlainShape {
  std::span<const Point> points;  ///< of a chain that ends where it began, the first not repeated
  bool joined = false;
  ShapeType type = ShapeType::kClosedPolygon;
  bool is_inner = false;  ///< a hole of the obstacle that was added last and is none
};

/// Adds an obstacle whose shape is set and whose points lie in Workspace::plain, with the feature's
/// semantics.
void finish_plain(const FeatureTask& task, PlainObstacle plain, double height_m,
                  Workspace& workspace);

/// The same for points that lie elsewhere.
void add_plain(const FeatureTask& task, const PlainShape& shape, double height_m,
               Workspace& workspace);

}  // namespace mapwright::converter
