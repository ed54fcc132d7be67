// How well a robot can know its place, all over a map.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/progress.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localizability/accuracy_field.hpp"
#include "navcore/localizability/place_grid.hpp"
#include "navcore/localizability/twin_search.hpp"

namespace mapwright::navcore {

struct LocalizabilitySettings {
  LaserModel laser;
  LaserNoise noise{0.05, 0.1};
  double cell_m = 0.5;                ///< side of the places
  std::optional<Box> window;          ///< nothing: the map's border
  double robot_radius_m = 0.0;        ///< places where the robot fits count
  std::size_t headings = 16;          ///< for the accuracy, over a full turn
  std::optional<double> heading_deg;  ///< this heading only, for accuracy and twins
  bool look_for_twins = true;
  double twin_spacing_m = 2.0;             ///< of the places that twins are looked for, at least
  std::size_t twin_index_poses = 400'000;  ///< looked at for candidates: fewer find fewer twins
  std::size_t twin_headings = 4;           ///< of the robot there, over a full turn
  double apart_m = 2.0;                    ///< nearer places are no confusion
  std::optional<double> compass_sigma_deg = 3.0;  ///< nothing: heading unknown
  unsigned threads = 1;  ///< 0: one a core. The field does not depend on it
};

/// A value for every place of a grid. Places where the robot does not stand have none.
struct LocalizabilityField {
  PlaceGrid grid;
  std::vector<char> stands;             ///< 1: the robot can stand at the cell's centre
  std::vector<PlaceAccuracy> accuracy;  ///< of one scan
  /// Twins of the place; those between the places that were looked at have the twin of the nearest
  /// one below and left, moved along.
  std::vector<PlaceTwins> twins;

  /// At least, in [0, 0.5]: of the heading mistaken most, and of the median heading.
  double worst_risk(std::size_t i) const;
  double median_risk(std::size_t i) const;
};

/// Cells that a window has; what `localizability_field` will take is in proportion.
std::size_t place_count(const Map& map, const LocalizabilitySettings& settings);

LocalizabilityField localizability_field(const Map& map, const FreeSpace& space,
                                         const LocalizabilitySettings& settings,
                                         const Progress& progress = {});

/// From where on a place counts as one where localization fails.
struct WeaknessLimits {
  double accuracy_m = 1.0;    ///< position known less well than this, edges and all
  double risk = 0.1;          ///< risk of confusion above this
  double min_area_m2 = 10.0;  ///< smaller areas are passed over
};

enum class Weakness {
  kInaccurate,  ///< one scan does not tell the position in some direction, at half of the headings
  kConfusable,  ///< another place looks the same, at half of the headings
};

/// Joined places of one weakness.
struct WeakArea {
  Weakness weakness = Weakness::kInaccurate;
  std::vector<std::size_t> cells;  ///< of the grid, ascending
  double area_m2 = 0.0;
  Box box = kEmptyBox;       ///< around the cells
  std::size_t middle = 0;    ///< the cell nearest to the middle of the area
  double accuracy_m = 0.0;   ///< the middle one of the cells' accuracies; infinite: nothing known
  double risk = 0.0;         ///< greatest risk of the cells
  std::size_t riskiest = 0;  ///< the cell that has it
};

/// Areas of joined weak places (by their sides), those of inaccuracy first, the largest first.
std::vector<WeakArea> weak_areas(const LocalizabilityField& field, const WeaknessLimits& limits);

/// How a quantity is spread over the places: its quantiles, and how often it is above a limit.
struct Spread {
  double median = 0.0, p75 = 0.0, p90 = 0.0, p95 = 0.0;  ///< infinite where unknown
  double share_above = 0.0;                              ///< in [0, 1]
};

struct LocalizabilitySummary {
  std::size_t places = 0;  ///< where the robot stands
  double area_m2 = 0.0;
  Spread worst_m, median_m;              ///< Cramér-Rao bound, major axis, at that heading
  Spread edges_worst_m, edges_median_m;  ///< with edges
  Spread heading_median_deg;             ///< bound of the heading, at the median heading
  Spread risk_worst, risk_median;        ///< of confusion
};
LocalizabilitySummary summary_of(const LocalizabilityField& field, const WeaknessLimits& limits);

}  // namespace mapwright::navcore
