#include "converter/ledger/obstacle_sources.hpp"

#include <nlohmann/json.hpp>
#include <unordered_set>

namespace mapwright::converter {
namespace {

constexpr std::string_view kSchema = "mapwright.convert/1";

}  // namespace

ObstacleSources::ObstacleSources(const Ledger& ledger, const std::vector<Finding>& findings) {
  std::unordered_set<std::int64_t> wanted;
  for (const auto& finding : findings) {
    if (finding.obstacle) wanted.insert(*finding.obstacle);
  }
  if (wanted.empty()) return;
  for (const auto& feature : ledger.features) {
    const auto& source = ledger.sources[feature.source];
    for (const auto id : feature.obstacles) {
      if (wanted.count(id) > 0) features_[id].push_back({source.path, source.layer, feature.fid});
    }
  }
}

Result<ObstacleSources> ObstacleSources::parse(std::string_view json) {
  ObstacleSources sources;
  try {
    const auto ledger = nlohmann::json::parse(json);
    if (ledger.at("schema") != kSchema) {
      return input_failure("this is no ledger; 'mapwright convert --report FILE' writes one");
    }
    for (const auto& feature : ledger.at("features")) {
      for (const auto id : feature.at("obstacles").get<std::vector<std::int64_t>>()) {
        sources.features_[id].push_back(
            {feature.at("source"), feature.at("layer"), feature.at("fid").get<std::int64_t>()});
      }
    }
  } catch (const nlohmann::json::exception& error) {
    return input_failure(std::string("this is no ledger of convert: ") + error.what());
  }
  return sources;
}

const std::vector<GisFeature>& ObstacleSources::of(std::int64_t obstacle) const {
  static const std::vector<GisFeature> none;
  const auto found = features_.find(obstacle);
  return found == features_.end() ? none : found->second;
}

void ObstacleSources::name_features(std::vector<Finding>& findings) const {
  for (auto& finding : findings) {
    if (!finding.obstacle) continue;
    if (const auto& features = of(*finding.obstacle); !features.empty())
      finding.features = features;
  }
}

}  // namespace mapwright::converter
