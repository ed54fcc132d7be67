#include "validators/deployment/localizability_findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

using navcore::LocalizabilityField;
using navcore::WeakArea;
using navcore::Weakness;

std::string number(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

Point rounded(Point p) {
  return {std::round(100.0 * p.x) / 100.0, std::round(100.0 * p.y) / 100.0};
}

std::string where(const LocalizabilityField& field, const WeakArea& area, std::size_t cell) {
  return "over " + number("%.0f", area.area_m2) + " m² around " +
         place_text(rounded(field.grid.center(cell)));
}

// How far the area reaches along a direction.
double length_along_m(const LocalizabilityField& field, const WeakArea& area, Angle direction) {
  const Point u = unit_vector(direction);
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (const std::size_t i : area.cells) {
    const double at = dot(u, field.grid.center(i));
    least = std::min(least, at);
    greatest = std::max(greatest, at);
  }
  return greatest - least + field.grid.cell_m;
}

std::string inaccurate_text(const LocalizabilityField& field, const WeakArea& area) {
  const auto& bound = field.accuracy[area.middle].edges_median.with_edges;
  const std::string place = where(field, area, area.middle);
  if (std::isinf(bound.minor_m)) {
    return place + " the laser has nothing in reach that tells the position" +
           "; add landmarks that it can see, or let the robot rely on its odometry there";
  }
  const double degrees = bound.major_direction.degrees();
  const std::string direction = number("%.0f", degrees + 0.0 == 0.0 ? 0.0 : degrees) + "°";
  const double length_m = length_along_m(field, area, bound.major_direction);
  // A bound beyond the area's own length is no bound: it says where in the area the robot is, and
  // that was known.
  const std::string what = area.accuracy_m >= length_m
                               ? " a scan does not tell the position along direction " + direction
                               : " a scan tells the position along direction " + direction +
                                     " no better than to " + number("%.1f", area.accuracy_m) + " m";
  return place + what +
         "; add a landmark that the laser sees there, or let the robot rely on its " +
         "odometry for " + number("%.0f", std::ceil(length_m)) + " m";
}

std::string confusable_text(const LocalizabilityField& field, const WeakArea& area) {
  const auto& twin = *field.twins[area.riskiest].median;
  return where(field, area, area.riskiest) + " a scan looks as at " +
         place_text(rounded(twin.pose.position())) + ", " +
         number("%.1f", distance(field.grid.center(area.riskiest), twin.pose.position())) +
         " m away: between the two at least " + number("%.0f", 100.0 * area.risk) +
         " % of single scans are mistaken; add a landmark to one of them, or start the robot with "
         "a "
         "known pose";
}

std::string rest_text(std::size_t count, double area_m2) {
  return " (and " + std::to_string(count) + " smaller area" + (count == 1 ? "" : "s") + " of " +
         number("%.0f", area_m2) + " m² together)";
}

Finding finding_of(const LocalizabilityField& field, const WeakArea& area) {
  const bool inaccurate = area.weakness == Weakness::kInaccurate;
  Finding finding =
      make_finding(inaccurate ? FindingCode::N107 : FindingCode::N108, weak_area_text(field, area));
  finding.at = rounded(field.grid.center(inaccurate ? area.middle : area.riskiest));
  const Box& box = area.box;
  finding.geometry.areas.push_back({{box.min_x, box.min_y},
                                    {box.max_x, box.min_y},
                                    {box.max_x, box.max_y},
                                    {box.min_x, box.max_y}});
  return finding;
}

}  // namespace

std::string weak_area_text(const LocalizabilityField& field, const WeakArea& area) {
  return area.weakness == Weakness::kInaccurate ? inaccurate_text(field, area)
                                                : confusable_text(field, area);
}

std::vector<Finding> localizability_findings(const LocalizabilityField& field,
                                             const std::vector<WeakArea>& areas, std::size_t most) {
  std::vector<Finding> findings;
  for (const Weakness weakness : {Weakness::kInaccurate, Weakness::kConfusable}) {
    std::size_t told = 0, rest = 0;
    double rest_m2 = 0.0;
    for (const WeakArea& area : areas) {
      if (area.weakness != weakness) continue;
      if (told < most) {
        findings.push_back(finding_of(field, area));
        ++told;
      } else {
        ++rest;
        rest_m2 += area.area_m2;
      }
    }
    if (rest > 0) findings.back().message += rest_text(rest, rest_m2);
  }
  return findings;
}

}  // namespace mapwright::validators
