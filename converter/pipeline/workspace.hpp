// What the builders of one conversion share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/ledger/ledger.hpp"
#include "converter/pipeline/clean_path.hpp"
#include "converter/pipeline/draft.hpp"
#include "converter/pipeline/map_transform.hpp"
#include "mapcore/geometry/ring_repair.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {

struct Workspace {
  Workspace(const RuleSettings& rule_settings, double resolution_m)
      : settings(rule_settings), resolution(resolution_m) {}

  Point snapped(Point p) const { return {resolution.rounded(p.x), resolution.rounded(p.y)}; }
  Snap snap() const {
    return [this](Point p) { return snapped(p); };
  }

  RuleSettings settings;
  text::DecimalFormat resolution;
  bool repair = true;
  std::vector<Draft> drafts;
  Ledger ledger;
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
};

/// Height of a solid or wall: what the rule read, else the default (and a remark).
double height_of(const FeatureTask& task, Workspace& workspace);

/// A draft with the feature's semantics; segments are yet to come.
Draft draft_for(const FeatureTask& task, ShapeType shape_type);

}  // namespace mapwright::converter
