// What a rule makes of one feature, before any geometry is built.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/rules/rule.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

struct Meaning {
  const Rule* rule = nullptr;  ///< null: no rule fits
  std::optional<double> height_m, base_height_m, radius_m, rise_m, width_m;
  bool height_is_fallback = false;  ///< the rule's number stands in for fields without a value
  std::optional<double> steps, step_no;
  std::string stair_id;
  std::optional<double> direction_deg;  ///< upwards, clockwise from the source grid's north
  std::optional<bool> upwards;          ///< of stairs drawn as a line: along the drawing direction
  std::optional<Normal> normal;         ///< as the fields have it, any length
  std::optional<double> slope_deg, aspect_deg;
  InOut in_out = InOut::kOutdoor;
  std::string semantic, segment_semantic;
  /// Fields with values that could not be understood: "height 'abc'".
  std::vector<std::string> unreadable;
  bool semantic_altered = false;  ///< reserved characters or commas had to be replaced

  /// As new, but for the memory of the texts.
  void clear() {
    rule = nullptr;
    for (auto* value : {&height_m, &base_height_m, &radius_m, &rise_m, &width_m, &steps, &step_no,
                        &direction_deg, &slope_deg, &aspect_deg}) {
      value->reset();
    }
    height_is_fallback = false;
    stair_id.clear();
    upwards.reset();
    normal.reset();
    in_out = InOut::kOutdoor;
    semantic.clear();
    segment_semantic.clear();
    unreadable.clear();
    semantic_altered = false;
  }
};

}  // namespace mapwright::converter
