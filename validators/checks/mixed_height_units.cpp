#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "validators/check.hpp"
#include "validators/shape/flight.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Fewer obstacles say nothing about what is usual.
constexpr std::size_t kFewObstacles = 3;

// A height is usual if it is within this factor of the map's median.
constexpr double kUsual = 4.0;

bool has_height(const Obstacle& obstacle) {
  return obstacle.shape_type != ShapeType::kStairs && obstacle.shape_type != ShapeType::kRamp &&
         max_height_m(obstacle) > 0.0;
}

std::size_t highest_segment(const Obstacle& obstacle) {
  std::size_t highest = 0;
  for (std::size_t k = 1; k < obstacle.segments.size(); ++k) {
    if (obstacle.segments[k].height_m > obstacle.segments[highest].height_m) highest = k;
  }
  return highest;
}

// "centimetres" or "millimetres" where the height in them is usual.
std::optional<std::string> suspected_unit(double height_m, double usual_m) {
  static constexpr std::array kUnits{std::pair{100.0, "centimetres"},
                                     std::pair{1000.0, "millimetres"}};
  for (const auto& [per_metre, name] : kUnits) {
    const double metres = height_m / per_metre;
    if (usual_m / kUsual <= metres && metres <= usual_m * kUsual) return name;
  }
  return std::nullopt;
}

void report(const CheckContext& context, std::size_t i, const std::string& suspicion,
            FindingSink& sink) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const std::size_t k = highest_segment(obstacle);
  sink.segment(FindingCode::S120, i, k, SegmentField::kHeight, obstacle.segments[k].a,
               name_of(obstacle, k) + " is " + metres(obstacle.segments[k].height_m) + " m high, " +
                   suspicion + "; heights are metres");
}

}  // namespace

void check_mixed_height_units(const CheckContext& context, FindingSink& sink) {
  if (context.in_doubt(Doubt::kHigh).empty()) return;
  const auto& obstacles = context.map().obstacles;
  const auto& options = context.options();
  std::vector<std::size_t> high;  // suspects
  std::vector<double> usual;      // heights of the others
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!has_height(obstacles[i])) continue;
    const double height_m = max_height_m(obstacles[i]);
    if (height_m <= options.suspect_height_m) {
      usual.push_back(height_m);
    } else if (height_m <= options.max_height_m) {  // else S107 tells
      high.push_back(i);
    }
  }
  if (high.empty() || high.size() + usual.size() < kFewObstacles) return;
  if (usual.empty()) {
    return report(context, high.front(),
                  "and nothing in the map is lower than " + metres(options.suspect_height_m) + " m",
                  sink);
  }
  const double usual_m = median(std::move(usual));
  for (const std::size_t i : high) {
    const auto unit = suspected_unit(max_height_m(obstacles[i]), usual_m);
    if (!unit) continue;
    report(context, i, "usual in the map are " + metres(usual_m) + " m: these may be " + *unit,
           sink);
  }
}

}  // namespace mapwright::validators
