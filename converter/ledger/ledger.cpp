#include "converter/ledger/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

namespace mapwright::converter {

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::kWritten:
      return "written";
    case Outcome::kChanged:
      return "changed";
    case Outcome::kDropped:
      return "dropped";
  }
  return "dropped";
}

std::size_t Ledger::open(std::size_t source, std::int64_t fid) {
  LedgerFeature feature;
  feature.source = static_cast<std::uint32_t>(source);
  feature.fid = fid;
  features.push_back(std::move(feature));
  ++sources[source].features;
  return features.size() - 1;
}

void Ledger::add_reason(std::size_t feature, LedgerReason reason) {
  auto& reasons = features[feature].reasons;
  if (reasons.empty()) explained_.push_back(static_cast<std::uint32_t>(feature));
  reasons.push_back(std::move(reason));
}

std::vector<std::uint32_t> Ledger::explained() const {
  auto positions = explained_;
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

void Ledger::remark(std::size_t feature, FindingCode code, std::string message) {
  add_reason(feature, {code, std::move(message), {}});
}

void Ledger::change(std::size_t feature, FindingCode code, std::string message, Measures measures) {
  if (features[feature].outcome == Outcome::kWritten) features[feature].outcome = Outcome::kChanged;
  add_reason(feature, {code, std::move(message), measures});
}

void Ledger::drop(std::size_t feature, FindingCode code, std::string message) {
  features[feature].outcome = Outcome::kDropped;
  remark(feature, code, std::move(message));
}

LedgerTotals Ledger::totals() const {
  LedgerTotals totals;
  for (const auto& feature : features) {
    ++totals.features;
    if (feature.outcome == Outcome::kWritten) ++totals.written;
    if (feature.outcome == Outcome::kChanged) ++totals.changed;
    if (feature.outcome == Outcome::kDropped) ++totals.dropped;
  }
  return totals;
}

bool balances(const Ledger& ledger) {
  std::vector<std::size_t> counted(ledger.sources.size());
  for (const auto& feature : ledger.features) {
    ++counted[feature.source];
    const bool dropped = feature.outcome == Outcome::kDropped;
    if (dropped && !feature.obstacles.empty()) return false;
    if (feature.outcome != Outcome::kWritten && feature.reasons.empty()) return false;
    if (!dropped && feature.obstacles.empty() && feature.reasons.empty()) return false;
  }
  for (std::size_t i = 0; i < counted.size(); ++i) {
    if (counted[i] != ledger.sources[i].features) return false;
  }
  const auto totals = ledger.totals();
  return totals.features == totals.written + totals.changed + totals.dropped;
}

namespace {

using Json = nlohmann::ordered_json;

// Texts come from strangers' files: what is not UTF-8 must not stop the report.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json source_json(const LedgerSource& source) {
  Json json{{"path", source.path},
            {"layer", source.layer},
            {"crs", source.crs},
            {"features", source.features}};
  if (!source.warnings.empty()) json["warnings"] = source.warnings;
  return json;
}

// Rounded to what a repair can be measured to.
double measured(double value) {
  return std::round(value * 1e6) / 1e6;
}

Json reason_json(const LedgerReason& reason) {
  Json json{{"code", finding_type(reason.code).id}, {"message", reason.message}};
  if (reason.measures.hausdorff_m) json["hausdorff_m"] = measured(*reason.measures.hausdorff_m);
  if (reason.measures.area_change_m2) {
    json["area_change_m2"] = measured(*reason.measures.area_change_m2);
  }
  return json;
}

Json feature_json(const LedgerFeature& feature, const LedgerSource& source) {
  Json reasons = Json::array();
  for (const auto& reason : feature.reasons) {
    reasons.push_back(reason_json(reason));
  }
  Json obstacles = Json::array();
  for (const auto id : feature.obstacles) obstacles.push_back(id);
  return {{"source", source.path},
          {"layer", source.layer},
          {"fid", feature.fid},
          {"outcome", to_string(feature.outcome)},
          {"obstacles", std::move(obstacles)},
          {"reasons", std::move(reasons)}};
}

}  // namespace

// One line a feature, so that a ledger of a million is a text file that tools can search.
void write_ledger(const Ledger& ledger, std::ostream& out) {
  const auto totals = ledger.totals();
  out << "{\"schema\":\"mapwright.convert/1\",\n\"sources\":[";
  for (std::size_t i = 0; i < ledger.sources.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n") << dumped(source_json(ledger.sources[i]));
  }
  out << "],\n\"totals\":"
      << dumped(Json{{"features", totals.features},
                     {"written", totals.written},
                     {"changed", totals.changed},
                     {"dropped", totals.dropped}});
  out << ",\n\"features\":[";
  bool is_first = true;
  for (const auto& feature : ledger.features) {
    out << (is_first ? "\n" : ",\n")
        << dumped(feature_json(feature, ledger.sources[feature.source]));
    is_first = false;
  }
  out << "]}\n";
}

}  // namespace mapwright::converter
