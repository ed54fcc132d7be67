#include "cli/localizability/answer_writers.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>

#include "cli/support/laser_json.hpp"
#include "cli/support/pose_json.hpp"
#include "validators/deployment/localizability_findings.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;
using navcore::Spread;
using navcore::WeakArea;

Json spread_json(const Spread& spread) {
  return {{"median", finite_or_null(spread.median)},
          {"p75", finite_or_null(spread.p75)},
          {"p90", finite_or_null(spread.p90)},
          {"p95", finite_or_null(spread.p95)},
          {"share_above_limit", spread.share_above}};
}

Json settings_json(const LocalizabilityAnswer& answer) {
  const auto& s = answer.settings;
  Json json;
  add_laser(json, s.laser, s.noise);
  json["cell_m"] = s.cell_m;
  json["robot_radius_m"] = s.robot_radius_m;
  json["headings"] = s.heading_deg ? Json(1) : Json(s.headings);
  json["heading_deg"] = s.heading_deg ? Json(*s.heading_deg) : Json(nullptr);
  json["compass_error_deg"] = s.compass_sigma_deg ? Json(*s.compass_sigma_deg) : Json(nullptr);
  json["apart_m"] = s.apart_m;
  json["limit_m"] = answer.limits.accuracy_m;
  json["limit_risk"] = answer.limits.risk;
  json["min_area_m2"] = answer.limits.min_area_m2;
  return json;
}

Json area_json(const navcore::LocalizabilityField& field, const WeakArea& area) {
  const bool inaccurate = area.weakness == navcore::Weakness::kInaccurate;
  const std::size_t cell = inaccurate ? area.middle : area.riskiest;
  const Point at = field.grid.center(cell);
  Json json;
  json["kind"] = inaccurate ? "inaccurate" : "confusable";
  json["area_m2"] = area.area_m2;
  json["at"] = {at.x, at.y};
  json["bbox"] = {area.box.min_x, area.box.min_y, area.box.max_x, area.box.max_y};
  json["accuracy_m"] = finite_or_null(area.accuracy_m);
  json["direction_deg"] = field.accuracy[cell].edges_median.with_edges.major_direction.degrees();
  json["risk"] = area.risk;
  json["twin"] = inaccurate ? Json(nullptr) : pose_json(field.twins[cell].median->pose);
  json["twin_distance_m"] =
      inaccurate ? Json(nullptr) : Json(distance(at, field.twins[cell].median->pose.position()));
  json["message"] = validators::weak_area_text(field, area);
  return json;
}

Json ratio_json(const navcore::RatioSpread& ratio) {
  return {{"p10", ratio.p10},
          {"median", ratio.median},
          {"p90", ratio.p90},
          {"correlation", ratio.correlation}};
}

Json tracked_json(const navcore::TrackedPlace& place) {
  Json json;
  json["pose"] = pose_json(place.pose);
  json["bound_m"] = {place.bound_major_m, place.bound_minor_m};
  json["with_edges_m"] = {place.edges_major_m, place.edges_minor_m};
  json["seen_m"] = {place.seen_major_m, place.seen_minor_m};
  json["bound_heading_deg"] = place.bound_heading_rad * 180.0 / std::numbers::pi;
  json["seen_heading_deg"] = place.seen_heading_rad * 180.0 / std::numbers::pi;
  return json;
}

Json risk_json(const navcore::RiskClass& risk) {
  return {{"risk_from", risk.from},
          {"risk_to", risk.to},
          {"places", risk.places},
          {"predicted_least", risk.predicted_least},
          {"predicted_most", risk.predicted_most},
          {"pair_tests", risk.pair_tests},
          {"pair_mistakes", risk.pair_mistakes},
          {"global_runs", risk.global_runs},
          {"global_mistakes", risk.global_mistakes}};
}

Json confirmation_json(const navcore::Confirmation& c) {
  Json json;
  json["seen_to_bound"] = {{"major", ratio_json(c.major_to_bound)},
                           {"minor", ratio_json(c.minor_to_bound)},
                           {"heading", ratio_json(c.heading_to_bound)}};
  json["seen_to_with_edges"] = {{"major", ratio_json(c.major_to_edges)},
                                {"minor", ratio_json(c.minor_to_edges)}};
  json["risk_classes"] = Json::array();
  for (const auto& risk : c.risks) json["risk_classes"].push_back(risk_json(risk));
  json["tracked"] = Json::array();
  for (const auto& place : c.tracked) json["tracked"].push_back(tracked_json(place));
  return json;
}

template <class... Values>
std::string line(const char* format, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return std::string(buffer) + "\n";
}

// "1.3 cm", "2.41 m", "unknown".
std::string length_text(double value_m) {
  char buffer[32];
  if (!std::isfinite(value_m)) return "unknown";
  if (value_m < 1.0) {
    std::snprintf(buffer, sizeof buffer, "%.1f cm", 100.0 * value_m);
  } else {
    std::snprintf(buffer, sizeof buffer, "%.2f m", value_m);
  }
  return buffer;
}

// "0.049 deg", "unknown".
std::string degrees_text(double value_deg) {
  char buffer[32];
  if (!std::isfinite(value_deg)) return "unknown";
  std::snprintf(buffer, sizeof buffer, "%.3f deg", value_deg);
  return buffer;
}

std::string spread_line(const char* what, const Spread& s, double limit_m) {
  return line("%-34s %9s %9s %9s %9s   %5.1f %% above %g m", what, length_text(s.median).c_str(),
              length_text(s.p75).c_str(), length_text(s.p90).c_str(), length_text(s.p95).c_str(),
              100.0 * s.share_above, limit_m);
}

std::string ratio_line(const char* what, const navcore::RatioSpread& r) {
  return line("%-34s %9.2f %9.2f %9.2f %12.2f", what, r.p10, r.median, r.p90, r.correlation);
}

void write_confirmation(std::ostream& out, const navcore::Confirmation& c) {
  out << "\n"
      << line("%-34s %9s %9s %9s %12s", "seen / predicted", "10 %", "median", "90 %",
              "correlation");
  out << ratio_line("major axis / bound", c.major_to_bound);
  out << ratio_line("minor axis / bound", c.minor_to_bound);
  out << ratio_line("heading / bound", c.heading_to_bound);
  out << ratio_line("major axis / with edges", c.major_to_edges);
  out << ratio_line("minor axis / with edges", c.minor_to_edges);
  if (c.risks.empty()) return;
  out << "\n"
      << line("%-20s %7s %22s %16s %16s", "risk of confusion", "places", "predicted mistakes",
              "of pairs, seen", "global, seen");
  for (const auto& risk : c.risks) {
    if (risk.places == 0) continue;
    const auto share = [](std::size_t part, std::size_t all) {
      return all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
    };
    out << line("%-9g to %-7g %7zu %9.3f to %6.3f %% %14.3f %% %14.1f %%", risk.from, risk.to,
                risk.places, 100.0 * risk.predicted_least, 100.0 * risk.predicted_most,
                share(risk.pair_mistakes, risk.pair_tests),
                share(risk.global_mistakes, risk.global_runs));
  }
}

}  // namespace

void write_localizability_json(std::ostream& out, const LocalizabilityAnswer& answer) {
  const auto& field = answer.field;
  const auto& s = answer.summary;
  Json json;
  json["schema"] = "mapwright.localizability/1";
  json["settings"] = settings_json(answer);
  json["grid"] = {{"corner", {field.grid.corner.x, field.grid.corner.y}},
                  {"cell_m", field.grid.cell_m},
                  {"columns", field.grid.columns},
                  {"rows", field.grid.rows}};
  json["places"] = s.places;
  json["area_m2"] = s.area_m2;
  json["position_sd_m"] = {{"worst_heading", spread_json(s.worst_m)},
                           {"median_heading", spread_json(s.median_m)}};
  json["with_edges_m"] = {{"worst_heading", spread_json(s.edges_worst_m)},
                          {"median_heading", spread_json(s.edges_median_m)}};
  json["heading_sd_deg"] = {{"median_heading", spread_json(s.heading_median_deg)}};
  json["alias_risk"] = answer.settings.look_for_twins
                           ? Json{{"worst_heading", spread_json(s.risk_worst)},
                                  {"median_heading", spread_json(s.risk_median)}}
                           : Json(nullptr);
  json["areas"] = Json::array();
  for (const auto& area : answer.areas) json["areas"].push_back(area_json(field, area));
  if (answer.confirmation) json["confirmation"] = confirmation_json(*answer.confirmation);
  json["output"] = answer.output.empty() ? Json(nullptr) : Json(answer.output);
  out << json.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

void write_localizability_text(std::ostream& out, const LocalizabilityAnswer& answer) {
  const auto& s = answer.summary;
  const double limit_m = answer.limits.accuracy_m;
  out << line("%zu places, %.0f m2", s.places, s.area_m2);
  out << line("%-34s %9s %9s %9s %9s", "position, least deviation", "median", "75 %", "90 %",
              "95 %");
  out << spread_line("any unbiased estimator, median h.", s.median_m, limit_m);
  out << spread_line("any unbiased estimator, worst h.", s.worst_m, limit_m);
  out << spread_line("with edges, median heading", s.edges_median_m, limit_m);
  out << spread_line("with edges, worst heading", s.edges_worst_m, limit_m);
  out << line("heading, median heading: %s (median), %s (95 %%)",
              degrees_text(s.heading_median_deg.median).c_str(),
              degrees_text(s.heading_median_deg.p95).c_str());
  if (answer.settings.look_for_twins) {
    out << line(
        "risk of confusion above %g: on %.2f %% of the places (median heading), %.2f %% (worst)",
        answer.limits.risk, 100.0 * s.risk_median.share_above, 100.0 * s.risk_worst.share_above);
  }
  for (const auto& area : answer.areas) {
    out << (area.weakness == navcore::Weakness::kInaccurate ? "N107 " : "N108 ")
        << validators::weak_area_text(answer.field, area) << '\n';
  }
  if (answer.confirmation) write_confirmation(out, *answer.confirmation);
}

}  // namespace mapwright::cli
