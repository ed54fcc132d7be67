#include "converter/importers/grid_description.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>

namespace mapwright::converter {
namespace {

[[noreturn]] void fail_at(const YAML::Node& node, const std::string& message) {
  throw YAML::RepresentationException(node.Mark(), message);
}

double finite_number(const YAML::Node& node, const std::string& key) {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail_at(node, key + ": expected a finite number");
  }
  return value;
}

void read_number(const YAML::Node& root, const std::string& key, double& target) {
  if (const YAML::Node node = root[key]) target = finite_number(node, key);
}

void read_origin(const YAML::Node& root, Pose& origin) {
  const YAML::Node node = root["origin"];
  if (!node) return;
  if (!node.IsSequence() || node.size() != 3) fail_at(node, "origin: expected [x, y, yaw]");
  origin = {finite_number(node[0], "origin"), finite_number(node[1], "origin"),
            Angle::from_radians(finite_number(node[2], "origin"))};
}

bool is_raw(const YAML::Node& root) {
  const YAML::Node node = root["mode"];
  if (!node) return false;
  const auto mode = node.as<std::string>();
  if (mode != "trinary" && mode != "scale" && mode != "raw") {
    fail_at(node, "mode: '" + mode + "' is none of trinary, scale, raw");
  }
  return mode == "raw";
}

bool is_negated(const YAML::Node& root) {
  const YAML::Node node = root["negate"];
  if (!node) return false;
  const auto word = node.as<std::string>();
  if (word == "0" || word == "false") return false;
  if (word == "1" || word == "true") return true;
  fail_at(node, "negate: '" + word + "' is neither 0 nor 1");
}

// Keys it does not know are passed over: map servers have their own.
GridDescription read_description(const YAML::Node& root) {
  if (!root.IsMap() || !root["image"]) fail_at(root, "no line 'image: FILE': is this a grid map?");
  GridDescription grid;
  grid.image = root["image"].as<std::string>();
  read_number(root, "resolution", grid.resolution_m);
  read_number(root, "occupied_thresh", grid.occupied_threshold);
  read_number(root, "free_thresh", grid.free_threshold);
  read_origin(root, grid.origin);
  grid.negate = is_negated(root);
  grid.raw = is_raw(root);
  if (!(grid.resolution_m > 0.0)) fail_at(root, "resolution: metres a pixel, above 0");
  if (!(grid.free_threshold <= grid.occupied_threshold)) {
    fail_at(root, "free_thresh is above occupied_thresh");
  }
  return grid;
}

Failure mistake(const std::string& name, const YAML::Mark& mark, const std::string& message) {
  return {FailureKind::kInput, name + ":" + std::to_string(mark.line + 1) + ":" +
                                   std::to_string(mark.column + 1) + ": error: " + message};
}

}  // namespace

Cell GridDescription::cell_of(double pixel) const {
  if (raw && pixel > 100.0) return Cell::kUnknown;
  const double shade = negate ? pixel / 255.0 : (255.0 - pixel) / 255.0;
  const double occupied = raw ? pixel / 100.0 : shade;
  if (occupied > occupied_threshold) return Cell::kOccupied;
  return occupied < free_threshold ? Cell::kFree : Cell::kUnknown;
}

Result<GridDescription> parse_grid_description(const std::string& yaml, const std::string& name) {
  try {
    return read_description(YAML::Load(yaml));
  } catch (const YAML::Exception& error) {
    return tl::unexpected(mistake(name, error.mark, error.msg));
  }
}

}  // namespace mapwright::converter
