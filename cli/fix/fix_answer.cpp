#include "cli/fix/fix_answer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "cli/support/findings_text.hpp"
#include "validators/report/json.hpp"
#include "validators/wording.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;
using validators::Repair;

std::string code_of(const Repair& repair) {
  return repair.code ? std::string(finding_type(*repair.code).id) : "layout";
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string codes_of(const std::vector<Finding>& findings) {
  std::string codes;
  for (const auto& finding : findings) {
    codes += (codes.empty() ? "" : ", ") + std::string(finding_type(finding.code).id);
  }
  return codes.empty() ? "no end of repairs" : codes;
}

void write_movements(std::ostream& out, const validators::FixOutcome& outcome) {
  double most = 0.0;
  for (const auto& [obstacle, moved_m] : outcome.moved) most = std::max(most, moved_m);
  if (outcome.moved.empty()) {
    out << "no obstacle moved\n";
  } else {
    out << counted(outcome.moved.size(), "obstacle") << " moved, by at most "
        << validators::metres(most) << " m\n";
  }
}

Json repair_json(const Repair& repair) {
  Json json;
  json["code"] = code_of(repair);
  json["obstacle"] = repair.obstacle ? Json(*repair.obstacle) : Json(nullptr);
  json["message"] = repair.message;
  json["moved_m"] = repair.moved_m;
  return json;
}

Json findings_json(const std::vector<Finding>& findings) {
  Json json = Json::array();
  for (const auto& finding : findings) {
    json.push_back(Json::parse(validators::finding_json(finding)));
  }
  return json;
}

Json undone_json(const Repair& repair) {
  Json json = repair_json(repair);
  json["would_bring"] = findings_json(repair.brought);
  return json;
}

Json moved_json(const validators::FixOutcome& outcome) {
  Json json = Json::array();
  for (const auto& [obstacle, moved_m] : outcome.moved) {
    json.push_back({{"obstacle", obstacle}, {"moved_m", moved_m}});
  }
  return json;
}

}  // namespace

void write_fix_text(std::ostream& out, const FixAnswer& answer) {
  const auto& outcome = answer.outcome;
  for (const auto& repair : outcome.done) {
    out << "repaired: " << repair.message << " [" << code_of(repair) << "]\n";
  }
  for (const auto& repair : outcome.undone) {
    out << "undone, it would bring " << codes_of(repair.brought) << ": " << repair.message << " ["
        << code_of(repair) << "]\n";
  }
  if (!outcome.done.empty()) write_movements(out, outcome);
  for (const auto& finding : answer.remaining) {
    if (finding.severity == Severity::kError) {
      out << finding_line(answer.output, finding) << '\n';
    }
  }
}

void write_fix_json(std::ostream& out, const FixAnswer& answer) {
  const auto& outcome = answer.outcome;
  Json json;
  json["schema"] = "mapwright.fix/1";
  json["path"] = answer.path;
  json["output"] = answer.output;
  json["verdict"] = has_errors(answer.remaining) ? "fail" : "pass";
  json["repairs"] = Json::array();
  for (const auto& repair : outcome.done) json["repairs"].push_back(repair_json(repair));
  json["undone"] = Json::array();
  for (const auto& repair : outcome.undone) json["undone"].push_back(undone_json(repair));
  json["moved"] = moved_json(outcome);
  json["border_moved_m"] = outcome.border_moved_m;
  json["findings_before"] = outcome.before.size();
  json["findings"] = findings_json(answer.remaining);
  if (!answer.diff.empty()) json["diff"] = answer.diff;
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace mapwright::cli
