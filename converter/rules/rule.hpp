// Rules: which layer and field means what (docs/rules.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "converter/rules/pattern.hpp"
#include "converter/source/feature.hpp"

namespace mapwright::converter {

enum class FeatureKind : std::uint8_t {
  kObstacle,  ///< written by `export`
  kSolid,
  kRoom,
  kWall,
  kSteps,
  kStairs,
  kRamp,
  kBorder,
  kIgnore,
};

std::string_view to_string(FeatureKind kind);
std::optional<FeatureKind> feature_kind(std::string_view name);

/// One way to a number: a constant, or a field with a unit, less another field.
struct QuantityTerm {
  std::optional<double> constant;
  std::string field;
  std::string minus;  ///< a field to subtract, in the same unit; empty: none
  double metres_per_unit = 1.0;
  bool storeys = false;  ///< the field counts storeys
  bool slope = false;    ///< the field is a steepness: degrees, or a text such as "8%"
};

/// The first term that has a value counts.
struct Quantity {
  std::vector<QuantityTerm> terms;
  bool empty() const { return terms.empty(); }
};

/// The steepness of a ramp, degrees.
struct SlopeQuantity : Quantity {};

/// Upwards, clockwise from the source grid's north.
struct Direction {
  std::vector<std::string> fields;  ///< the first with a value counts
  std::optional<double> constant_deg;
};

/// A text with {field} in it; tokens whose fields are empty vanish.
struct SemanticTemplate {
  std::string text;
};

/// A condition on a field's value.
struct Condition {
  enum class Test { kPattern, kPresent, kAbsent, kLess, kLessEqual, kGreater, kGreaterEqual, kNot };
  std::string field;
  Test test = Test::kPattern;
  std::vector<Pattern> patterns;  ///< of kPattern and kNot
  double bound = 0.0;
};

enum class NormalAxes { kAuto, kSource, kMap };

struct Rule {
  std::string name;
  std::vector<Pattern> layers;           ///< empty: every layer
  std::vector<GeometryKind> geometries;  ///< empty: any
  std::vector<Condition> where;
  FeatureKind kind = FeatureKind::kIgnore;

  Quantity height, base_height, radius, rise, width, steps;
  std::vector<std::string> in_out;  ///< fields, the first with a value counts; or a word
  SemanticTemplate semantic, segment_semantic;
  std::string reason;

  std::vector<std::string> stair_id, step_no;  ///< fields, the first with a value counts
  Direction direction;
  std::vector<std::string> normal_x, normal_y, normal_z;
  SlopeQuantity slope;
  Quantity aspect;
  NormalAxes axes = NormalAxes::kAuto;

  int line = 0;  ///< in the rules file, 1-based
};

struct RuleSettings {
  double robot_height_m = 2.0;
  double default_height_m = 1.0;
  double storey_height_m = 3.0;
  double rise_m = 0.17;
  double tread_m = 0.30;
  double border_margin_m = 1.0;
};

struct RuleSet {
  std::string name;  ///< of the built-in set, or the file's path
  RuleSettings settings;
  std::vector<Rule> rules;
};

}  // namespace mapwright::converter
