// What the verb diff found, and its writers.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "converter/exporters/picture.hpp"
#include "mapcore/diff/map_diff.hpp"
#include "navcore/diff/navigation_diff.hpp"

namespace mapwright::cli {

struct DiffAnswer {
  std::string path_before, path_after;  ///< as messages name them
  Map before, after;
  MapDiff obstacles;
  std::optional<navcore::NavigationDiff> navigation;
  std::string navigation_missing;  ///< why there is none; empty where nobody asked for it
  navcore::NavigationDiffSettings settings;

  /// True if the robot notices nothing either. What other numbers are is no difference.
  bool same() const { return obstacles.same() && (!navigation || navigation->same()); }
};

/// Lines for people: nothing where nothing differs.
void write_diff_text(std::ostream& out, const DiffAnswer& answer, bool colour);

/// Schema mapwright.diff/1 (docs/cli.md).
void write_diff_json(std::ostream& out, const DiffAnswer& answer);

/// A page of both maps, one over the other.
void write_diff_html(std::ostream& out, const DiffAnswer& answer);

/// The new map with what changed drawn over it. Throws Error for a picture that cannot be drawn.
std::string draw_diff(const DiffAnswer& answer, converter::PictureFormat format);

}  // namespace mapwright::cli
